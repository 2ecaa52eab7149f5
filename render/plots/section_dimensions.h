#pragma once

#include <string>
#include <vector>

#include "render/plots/section_cut.h"

namespace scb::render {

class Overlay;

/// A length along the direction of a step, drawn beside the section, with its number.
struct SectionDimension {
    double from = 0, to = 0;  ///< heights in the section
    Rgba8 color;
    std::string label;  ///< may be empty
    int column = 0;     ///< of section_dimension_columns
    bool strong = false;
};
inline constexpr int section_dimension_columns = 4;

/// "r_e = 0.105".
std::string length_text(const std::string& name, double value);

/// The width that they need.
int dimensions_width(Overlay& overlay, const std::vector<SectionDimension>& dimensions, int unit);

/// Draws them into `box`, which lies right of the section's rectangle and is as high.
void draw_dimensions(Overlay& overlay, const SectionScale& scale, const PixelRect& box,
                     std::vector<SectionDimension> dimensions, const Theme& theme, int unit,
                     double line_width);

}  // namespace scb::render
