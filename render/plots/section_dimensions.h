#pragma once

#include <string>
#include <vector>

#include "render/plots/section_cut.h"

namespace scb::render {

class Overlay;

/// A length along the direction of a step, drawn beside the section.
struct SectionDimension {
    double from = 0, to = 0;  ///< heights in the section
    Rgba8 color;
    std::string name;
    double value = 0;
    bool strong = false;
};

/// The numbers with enough decimals for three digits of all that matter. They are rounded so that
/// the last, the sum of the others, is the sum of the printed numbers: 0.093252, −0.034666,
/// −0.058214, +0.000372. Numbers that vanish at these decimals are 0.
std::vector<std::string> sum_texts(const std::vector<double>& terms_and_sum);

/// The width that they need.
int dimensions_width(Overlay& overlay, const std::vector<SectionDimension>& dimensions, int unit);

/// Draws them into `box`, which lies right of the section's rectangle and is as high: each in a
/// column of its own. A table of their numbers has the same order; the last number is the sum.
void draw_dimensions(Overlay& overlay, const SectionScale& scale, const PixelRect& box,
                     const std::vector<SectionDimension>& dimensions, const Theme& theme, int unit,
                     double line_width);

}  // namespace scb::render
