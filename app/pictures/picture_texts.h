#pragma once

#include <string>
#include <vector>

#include "app/pictures/picture_options.h"
#include "render/files/image_file.h"

namespace scb::app {

/// Texts in the PNG files of a run: the program and its version, the scene (none if empty), and the
/// command. They are the same on every machine, since they name files without folders.
std::vector<render::PngText> picture_texts(const PictureOptions& options, const std::string& scene);

}  // namespace scb::app
