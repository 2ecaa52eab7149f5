#pragma once

#include <array>
#include <cstdint>

#include "render/overlay/scales.h"

namespace scb::render {

/// The numbers of volumes by diameter d and by thickness τ: two histograms on one scale, lengths
/// relative to the largest root's d, so that histograms of all levels can be compared.
struct LengthHistogram {
    static constexpr int halvings = 14;    ///< halvings of the root's d that the scale spans
    static constexpr int per_halving = 2;  ///< bins
    static constexpr int bins = halvings * per_halving;
    /// From the root's d down; the last bin has all smaller lengths, including 0.
    using Counts = std::array<std::uint32_t, bins + 1>;

    double root_diameter = 1;
    Counts diameters{}, thicknesses{};
    bool differ = false;  ///< whether any τ differs from d: balls have one histogram

    void add(double diameter, double thickness);
};

/// Draws the histograms inside the rectangle, d above τ, long at the right. Returns the covered
/// part; it is empty, and nothing is drawn, if there is no room.
PixelRect draw_length_histogram(Overlay& overlay, const PixelRect& rect,
                                const LengthHistogram& histogram, const FigureStyle& style);

/// Its height if it has enough room.
int length_histogram_height(const FigureStyle& style);

}  // namespace scb::render
