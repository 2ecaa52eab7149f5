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

/// Hold this lock while drawing, without the interpreter's lock: only one thread at a time may use
/// the OpenGL library and ImGui.
std::unique_lock<std::mutex> lock_drawing();

/// The options as from the command line.
app::PictureOptions picture_options(const PictureSize& size, int samples,
                                    const std::string& background, bool panel,
                                    const std::string& gl);
app::CameraOptions camera_options(const std::string& camera, bool orthographic,
                                  const std::string& up);
/// Throws InputError if the name is unknown.
std::optional<render::ColorBy> color_by_of(const std::optional<std::string>& name);
/// A frame as text for --frames; empty without a frame.
std::string frame_text(std::optional<std::int64_t> frame);

void add_pictures(py::module_& module);

}  // namespace scb::python
