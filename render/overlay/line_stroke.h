#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/overlay/scales.h"

namespace scb::render {

/// Solid, or a pattern, for readers who cannot distinguish the colors; from the fullest to the
/// sparsest. Lines drawn in this order are visible even if they lie on top of each other.
enum class LineStroke { solid, long_dashed, dashed, dash_dotted, dotted };

inline constexpr std::size_t line_stroke_count = 5;

/// The stroke of the i-th of several lines of one kind: first solid, then the most different
/// patterns first. Beyond the fifth they repeat.
LineStroke stroke_of_line(std::size_t i);

/// The width of the lines of plots, in pixels.
int stroke_width(const FigureStyle& style);

/// Draws a line through the points, or a dot for one point.
void draw_stroke(Overlay& overlay, const std::vector<ScreenPosition>& points, Rgba8 color,
                 LineStroke stroke, double thickness);

/// Draws a piece of a line for a legend, from x on, with its middle at y: thicker than in the plot,
/// so that color and pattern are visible.
void draw_line_sample(Overlay& overlay, int x, int y, int width, Rgba8 color, LineStroke stroke,
                      const FigureStyle& style);

/// The width that a sample needs so that its pattern is visible.
int line_sample_width(const FigureStyle& style);

/// A line through the points (pixels), `thickness` pixels wide, with round ends and joints; a
/// single point is a dot. It is smoothed: a pixel's opacity is the share of it that the line
/// covers; crossings of the line with itself count once. The coverage is computed in integers, and
/// pixels are drawn as an overlay's rectangles, so the bytes are the same everywhere, as for all of
/// Overlay. Positions must be finite.
void draw_smooth_line(Overlay& overlay, std::span<const ScreenPosition> points, Rgba8 color,
                      double thickness);

/// The line cut into dashes. The pattern has the lengths of dashes and gaps in turn, beginning with
/// a dash (in pixels, at least 1 each, an even number of lengths).
std::vector<std::vector<ScreenPosition>> dashes(std::span<const ScreenPosition> points,
                                                std::span<const double> pattern);

}  // namespace scb::render
