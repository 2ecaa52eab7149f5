#pragma once

#include <array>
#include <optional>

#include "core/analysis/ended_paths.h"
#include "render/figures/query_body.h"
#include "render/figures/scene_figure.h"

namespace scb::render {

/// What the color of a front node tells: one of its endings, or the share of its tests that were
/// rejected.
enum class FrontColor { first, last, dominant, share };

std::string_view front_color_name(FrontColor color);
std::optional<FrontColor> front_color_of(std::string_view name);

/// What pictures of a traversal's front show.
struct RejectionsStyle {
    FrontColor by = FrontColor::dominant;
    EndedPathsFilter filter;
    std::array<bool, 2> sides = {true, true};  ///< which bodies
    bool nested = false;                       ///< also nodes that hold others of the front
    double opacity = 1;                        ///< of the volumes
    const Theme* theme = &light_theme;
};

/// Both fronts of a query; empty on a side that is not shown.
using Fronts = std::array<std::vector<EndedPaths>, 2>;
Fronts fronts_of(const QueryBodies& bodies, const TraceFrame& frame, const TraversalTree& tree,
                 const RejectionsStyle& style);

/// The front of the traversal: each node at which paths ended as its exact volume, with its
/// ending's color.
Pane rejections_pane(const QueryBodies& bodies, const Fronts& fronts, const RejectionsStyle& style);

/// The query's endings with their counts and shares.
std::vector<PanelItem> endings_legend(const TraceHeader& header, const TraceFrame& frame,
                                      const TraversalTree& tree, const Theme& theme);

/// What the color of a node tells.
PanelItem front_color_key(const RejectionsStyle& style);

/// Its numbers and legend: every ending of the query with its count and share, whatever the filter
/// shows.
std::vector<PanelItem> rejections_panel(const QueryBodies& bodies, const TraceHeader& header,
                                        const TraceFrame& frame, const TraversalTree& tree,
                                        const Fronts& fronts, const RejectionsStyle& style);

/// How the tests of each depth of pairs ended, as stacked bars.
PanelChart endings_chart(const TraceHeader& header, const TraceFrame& frame,
                         const TraversalTree& tree, const Theme& theme);

}  // namespace scb::render
