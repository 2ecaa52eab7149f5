#include "render/draw/resolve.h"

#include <array>
#include <bit>
#include <cassert>

namespace scb::render {
namespace {

// The position of alpha in a word depends on the machine.
constexpr auto opaque = std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{0, 0, 0, 255});

/// The mean of four words byte by byte: two bytes at a time, so that no sum runs into the next.
std::uint32_t mean(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    constexpr std::uint32_t low = 0x00ff00ff, two = 0x00020002;
    const std::uint32_t even = (a & low) + (b & low) + (c & low) + (d & low) + two,
                        odd =
                            (a >> 8 & low) + (b >> 8 & low) + (c >> 8 & low) + (d >> 8 & low) + two;
    return (even >> 2 & low) | (odd >> 2 & low) << 8;
}

}  // namespace

void resolve_colors(const std::uint32_t* samples, int scale, std::span<std::uint32_t> row) {
    assert(scale == 1 || scale == 2);
    if (scale == 1) {
        for (std::size_t x = 0; x < row.size(); ++x) row[x] = samples[x] | opaque;
        return;
    }
    const std::uint32_t* other = samples + 2 * row.size();
    for (std::size_t x = 0; x < row.size(); ++x)
        row[x] = mean(samples[2 * x], samples[2 * x + 1], other[2 * x], other[2 * x + 1]) | opaque;
}

void resolve_ids(const std::uint32_t* samples, int scale, std::span<std::uint32_t> row) {
    const auto step = static_cast<std::size_t>(scale);
    const std::uint32_t* last = samples + (step - 1) * step * row.size();
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = last[step * x];
}

}  // namespace scb::render
