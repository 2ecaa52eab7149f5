#pragma once

#include "render/view/picture.h"

namespace scb::app {

/// The picture with volumes and meshes that have one more of 255 in their green, or one less where
/// it is 255: an error on purpose, for `scb golden selftest`, which no eye sees.
render::Picture shifted_colors(render::Picture picture);

}  // namespace scb::app
