#pragma once

#include "render/view/picture.h"

namespace scb::render {

/// Draws the outline of the things that own pixels of `pane` in `ids`. Around all of them together
/// is a ring of `color`, and around it a thinner ring of `halo`, so that the outline shows on any
/// color. `ids` and the image have the same size.
void draw_outline(Image& image, const IdImage& ids, const PixelRect& pane, const Outline& outline);

}  // namespace scb::render
