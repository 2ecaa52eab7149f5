#pragma once

#include <string>

#include "core/analysis/distance_steps.h"
#include "render/overlay/overlay.h"
#include "render/plots/depth_matrix_plot.h"
#include "render/view/picture.h"

namespace scb::render {

/// The cost of one frame's traversal in the domain of pairs, without a camera.
struct TraversalFigure {
    std::string title;
    std::string subtitle;
    MatrixMeasure measure = MatrixMeasure::tests;
    bool matrix = true;  ///< volume tests by depth of A and depth of B
    bool icicle = true;  ///< the recursion: width is tests, color is outcome
    bool part = false;   ///< the frame is a part of a query, see traversal_part
    /// Of a query of distances: bounds by depth, in place of both diagrams. Null: none.
    const DistanceSteps* bounds = nullptr;
    const Theme* theme = &light_theme;
};

/// Composes the figure of a frame, with its counts and the legend of outcomes: the picture has no
/// panes, all is in the overlay. Matrix and icicle are side by side, or above each other if the
/// picture is taller than wide. A tiny picture has neither legend nor notes.
Picture compose(const TraversalFigure& figure, const TraceHeader& header, const QueryTrace& frame,
                int width, int height, Overlay& overlay);

}  // namespace scb::render
