#pragma once

#include <string>
#include <vector>

#include "app/query/query_options.h"

namespace scb::app {

/// The arguments of a case of pairs or rejections that draws a frame from where most of the contact
/// is visible, as `scb render pairs` finds it: a camera; nothing if the usual direction or the
/// scene's own camera shows the contact, or if there is none. `bodies`: as --bodies has them, or
/// empty. `size`: of the picture, without a panel. Throws InputError, GlError.
std::vector<std::string> seeing_camera_words(const SceneOptions& scene, const std::string& bodies,
                                             int frame, const std::string& size);

}  // namespace scb::app
