#pragma once

#include <cstddef>
#include <vector>

#include "render/overlay/scales.h"

namespace scb::render {

/// In full, or in one of the patterns that can be told apart where colors cannot; from the fullest
/// to the sparsest. Lines drawn in this order show even where they lie on top of each other.
enum class LineStroke { solid, long_dashed, dashed, dash_dotted, dotted };

inline constexpr std::size_t line_stroke_count = 5;

/// The stroke of the i-th of several lines of one kind: the first is solid, then the most unlike
/// ones first. Beyond the fifth they repeat.
LineStroke stroke_of_line(std::size_t i);

/// How wide the lines of plots are, in pixels.
int stroke_width(const FigureStyle& style);

/// A line through the points, a dot where it is one point.
void draw_stroke(Overlay& overlay, const std::vector<ScreenPosition>& points, Rgba8 color,
                 LineStroke stroke, double thickness);

/// A piece of line from x on, with its middle at y, as legends show it: thicker than in the plot,
/// for color and pattern to be seen.
void draw_line_sample(Overlay& overlay, int x, int y, int width, Rgba8 color, LineStroke stroke,
                      const FigureStyle& style);

/// How wide a sample must be for its pattern to be seen.
int line_sample_width(const FigureStyle& style);

}  // namespace scb::render
