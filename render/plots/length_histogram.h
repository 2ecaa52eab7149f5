#pragma once

#include <array>
#include <cstdint>

#include "render/overlay/scales.h"

namespace scb::render {

/// How many volumes have which diameter d and thickness τ: two histograms on one scale, that of d
/// over the largest root's, so that those of all levels compare.
struct LengthHistogram {
    static constexpr int halvings = 14;    ///< of the root's d that the scale spans
    static constexpr int per_halving = 2;  ///< bins
    static constexpr int bins = halvings * per_halving;
    /// From the root's d down; the last one has all lengths that are smaller, 0 too.
    using Counts = std::array<std::uint32_t, bins + 1>;

    double root_diameter = 1;
    Counts diameters{}, thicknesses{};
    bool differ = false;  ///< whether any τ is not d: of balls there is one histogram

    void add(double diameter, double thickness);
};

/// Draws it into the rectangle, d above τ, long at the right, and nothing outside. Returns its part
/// that is covered, which is empty where there is no room; then nothing is drawn.
PixelRect draw_length_histogram(Overlay& overlay, const PixelRect& rect,
                                const LengthHistogram& histogram, const FigureStyle& style);

/// How high it is where it has the room that it needs.
int length_histogram_height(const FigureStyle& style);

}  // namespace scb::render
