#pragma once

#include <cstddef>

namespace scb::golden {

/// How much colors of a case may differ; by default not at all.
struct ColorTolerance {
    int max_channel_delta = 0;
    std::size_t max_pixels = 0;  ///< pixels that differ by more than this

    friend bool operator==(const ColorTolerance&, const ColorTolerance&) = default;
};

}  // namespace scb::golden
