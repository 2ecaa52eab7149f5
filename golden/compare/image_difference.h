#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "golden/compare/pixel_box.h"
#include "golden/suite/suite.h"
#include "render/files/image.h"

namespace scb::golden {

/// The difference of two pictures of one size.
struct ImageDifference {
    std::size_t pixels = 0;  ///< pixels that differ in any channel
    PixelBox box;            ///< about all of these; empty if there are none
    int largest = 0;         ///< difference of a channel, 0 to 255

    /// At [d], the number of pixels with a channel that differs by more than d: with a tolerance of
    /// d per channel, so many pixels would still differ.
    std::array<std::size_t, 256> beyond{};

    friend bool operator==(const ImageDifference&, const ImageDifference&) = default;
};

/// Compares all channels of all pixels. The sizes must be equal.
ImageDifference image_difference(const render::Image& a, const render::Image& b);

/// The box of the pixels that differ in a part of the pictures; empty if none does. The sizes must
/// be equal, and the part must lie within.
PixelBox changed_box(const render::Image& a, const render::Image& b, const PixelBox& part);

bool within(const ImageDifference& difference, const ColorTolerance& tolerance);

/// A picture of the difference: equal pixels are `b` in pale grey; other pixels have the changed
/// color, a little stronger for larger differences. The sizes must be equal.
render::Image difference_picture(const render::Image& a, const render::Image& b);

/// The boxes about the clusters of changed pixels in a picture of a difference, those which are not
/// grey: at most `most`, and at least one. Where there are more, near ones are joined.
std::vector<PixelBox> changed_clusters(const render::Image& difference, std::size_t most);

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
