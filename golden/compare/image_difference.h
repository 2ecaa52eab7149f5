#pragma once

#include <array>
#include <cstddef>

#include "golden/compare/pixel_box.h"
#include "render/files/image.h"

namespace scb {

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

/// How colors may differ where a case says so; by default not at all.
struct ColorTolerance {
    int max_channel_delta = 0;
    std::size_t max_pixels = 0;  ///< that differ by more than that

    friend bool operator==(const ColorTolerance&, const ColorTolerance&) = default;
};

/// Compares all channels of all pixels. The sizes must be equal.
ImageDifference image_difference(const Image& a, const Image& b);

bool within(const ImageDifference& difference, const ColorTolerance& tolerance);

/// A picture of the difference: where they agree, `b` in pale grey; where they do not, the accent
/// color, the stronger the more they differ, but never too faint to be seen. The sizes must be
/// equal.
Image difference_picture(const Image& a, const Image& b);

}  // namespace scb
