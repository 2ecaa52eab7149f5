#pragma once

#include <array>
#include <cstddef>

#include "golden/compare/pixel_box.h"
#include "golden/suite/color_tolerance.h"
#include "render/files/image.h"

namespace scb::golden {

/// By how much two pictures of one size differ.
struct ImageDifference {
    std::size_t pixels = 0;  ///< that differ in any channel
    PixelBox box;            ///< about all of these; empty where there are none
    int largest = 0;         ///< difference of a channel, 0 to 255

    /// At [d], how many pixels have a channel that differs by more than d: what a tolerance of d a
    /// channel would still have to allow.
    std::array<std::size_t, 256> beyond{};

    friend bool operator==(const ImageDifference&, const ImageDifference&) = default;
};

/// Compares all channels of all pixels. The sizes must be equal.
ImageDifference image_difference(const render::Image& a, const render::Image& b);

/// About the pixels of a part of the pictures that differ; empty where none does. The sizes must be
/// equal, and the part lie within.
PixelBox changed_box(const render::Image& a, const render::Image& b, const PixelBox& part);

bool within(const ImageDifference& difference, const ColorTolerance& tolerance);

/// A picture of the difference: where they agree, `b` in pale grey; where they do not, the accent
/// color, the stronger the more they differ, but never too faint to be seen. The sizes must be
/// equal.
render::Image difference_picture(const render::Image& a, const render::Image& b);

}  // namespace scb::golden
