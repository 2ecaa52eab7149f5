#pragma once

#include "render/view/picture.h"

namespace scb::app {

/// The picture with the green of volumes and meshes changed by 1 of 255 (up, or down from 255): a
/// deliberate, invisible error for `scb golden selftest`.
render::Picture shifted_colors(render::Picture picture);

}  // namespace scb::app
