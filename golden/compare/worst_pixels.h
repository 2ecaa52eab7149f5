#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "golden/compare/pixel_box.h"
#include "render/files/image.h"

namespace scb::golden {

/// A pixel that has another color than before.
struct PixelChange {
    int x = 0, y = 0;  ///< from the left, from the top
    render::Rgba8 before, after;

    /// The differences of red, green, blue, alpha.
    std::array<int, 4> by() const;
    /// The largest of them, without its sign.
    int most() const;
};

/// The pixels that differ most in a part of the pictures, at most `listed`; ties in the order of
/// rows from the top. Both pictures must have one size; the part is cut to them.
std::vector<PixelChange> worst_pixels(const render::Image& before, const render::Image& after,
                                      const PixelBox& part, std::size_t listed);

}  // namespace scb::golden
