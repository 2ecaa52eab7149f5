#pragma once

#include "render/view/picture.h"

namespace scb::render {

/// Draws the outline of the things that own pixels of `pane` in `ids`: around all of them together,
/// outside, a ring of `color` and about it a thinner one of `halo`, so that it shows on any color.
/// `ids` and the image have the same size.
void draw_outline(Image& image, const IdImage& ids, const PixelRect& pane, const Outline& outline);

}  // namespace scb::render
