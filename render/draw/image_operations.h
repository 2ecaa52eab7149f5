#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/files/image.h"
#include "render/view/picture.h"

namespace scb::render {

/// Draws the outline of the things that own pixels of `pane` in `ids`. Around all of them together
/// is a ring of `color`, and around it a thinner ring of `halo`, so that the outline shows on any
/// color. `ids` and the image have the same size.
void draw_outline(Image& image, const IdImage& ids, const PixelRect& pane, const Outline& outline);

/// The ids, ascending, of volumes and triangles of meshes that only one of two panes has, or that
/// differ in color. The same thing must have the same id in both panes, and a mesh must have colors
/// of its triangles in both or in neither. Segments are ignored.
std::vector<std::uint32_t> differing_ids(const Pane& a, const Pane& b);

/// One row of a picture from the rows of its samples: each pixel is the mean of scale x scale
/// samples, in integers, so that the rounding is the same everywhere; opaque. A color is the word
/// of its bytes r, g, b, a in memory. `samples` has `scale` rows of scale * row.size() words; scale
/// is 1 or 2.
void resolve_colors(const std::uint32_t* samples, int scale, std::span<std::uint32_t> row);

/// The same for ids: each pixel has the id of its left sample in the last row.
void resolve_ids(const std::uint32_t* samples, int scale, std::span<std::uint32_t> row);

/// A part of a picture, shrunk to the given size: each pixel is the mean of the pixels that it
/// covers. The part must be inside the picture and not be smaller than the result.
Image shrunk(const Image& picture, const PixelRect& part, int width, int height);

}  // namespace scb::render
