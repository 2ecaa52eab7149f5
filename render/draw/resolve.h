#pragma once

#include <cstdint>
#include <span>

namespace scb::render {

/// One row of a picture from the rows of its samples: each pixel is the mean of scale x scale
/// samples, in integers, so that the rounding is the same everywhere; opaque. A color is the word
/// of its bytes r, g, b, a in memory. `samples` has `scale` rows of scale * row.size() words; scale
/// is 1 or 2.
void resolve_colors(const std::uint32_t* samples, int scale, std::span<std::uint32_t> row);

/// The same for ids: each pixel has the id of its left sample in the last row.
void resolve_ids(const std::uint32_t* samples, int scale, std::span<std::uint32_t> row);

}  // namespace scb::render
