#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "app/pictures/level_options.h"
#include "app/pictures/picture_options.h"
#include "app/python/binding/errors.h"

namespace scb::python {

/// Width and height.
using PictureSize = std::pair<int, int>;

/// To be held while something is drawn, without the interpreter's lock: OpenGL's library and ImGui
/// are of one thread at a time.
std::unique_lock<std::mutex> lock_drawing();

/// As the command line has it.
app::PictureOptions picture_options(const PictureSize& size, int samples,
                                    const std::string& background, bool panel,
                                    const std::string& gl);
app::CameraOptions camera_options(const std::string& camera, bool orthographic,
                                  const std::string& up);
/// Throws InputError where there is no such name.
std::optional<render::ColorBy> color_by_of(const std::optional<std::string>& name);
/// A frame as --frames has it; empty of none.
std::string frame_text(std::optional<std::int64_t> frame);

void add_pictures(py::module_& module);

}  // namespace scb::python
