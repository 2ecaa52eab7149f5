#pragma once

#include <string>
#include <vector>

#include "app/pictures/picture_options.h"
#include "render/files/image_file.h"

namespace scb::app {

/// What the PNG files of a run say of themselves: the program and its version, the scene (none
/// where it is empty), and the command. The same on every machine, with names of files, but not of
/// their folders.
std::vector<render::PngText> picture_texts(const PictureOptions& options, const std::string& scene);

}  // namespace scb::app
