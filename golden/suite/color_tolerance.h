#pragma once

#include <cstddef>

namespace scb::golden {

/// How colors may differ where a case says so; by default not at all.
struct ColorTolerance {
    int max_channel_delta = 0;
    std::size_t max_pixels = 0;  ///< that differ by more than that

    friend bool operator==(const ColorTolerance&, const ColorTolerance&) = default;
};

}  // namespace scb::golden
