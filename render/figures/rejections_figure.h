#pragma once

#include <array>

#include "core/analysis/ended_paths.h"
#include "core/base/enum_names.h"
#include "render/figures/query_body.h"
#include "render/figures/scene_figure.h"
#include "render/plots/ending_colors.h"

namespace scb::render {

/// What colors a node at which paths ended: one of its endings, or the share of its tests that
/// rejected.
enum class NodeColor { first, last, dominant, share };

inline constexpr EnumNames<NodeColor, 4> node_color_names = {"first", "last", "dominant", "share"};

/// How pictures show the nodes at which the paths of a traversal ended.
struct RejectionsStyle {
    NodeColor by = NodeColor::dominant;
    EndedPathsFilter filter;
    std::array<bool, 2> sides = {true, true};  ///< which bodies
    bool nested = false;                       ///< also nodes that hold other drawn nodes
    /// Which share of the ended paths has to be seen: those nodes are left out that have the
    /// fewest paths for their size, squared, as long as no more than the other paths ended there.
    /// Large volumes end few paths, and hide many.
    double focus = 1;
    double opacity = 1;  ///< of the volumes
    const Theme* theme = &light_theme;
};

/// The nodes at which paths of a query ended, of both bodies; empty on a side that is not shown.
using EndedNodes = std::array<std::vector<EndedPaths>, 2>;
EndedNodes ended_nodes(const QueryBodies& bodies, const TraceFrame& frame, const Outcomes& outcomes,
                       const RejectionsStyle& style);

/// Each node at which paths ended, with its ending's color, those of B hatched: as its exact
/// volume, or, where its triangle was tested, as that; behind them faintly the meshes, and before
/// all the lines in which triangles meet.
Pane rejections_pane(const QueryBodies& bodies, const TraceFrame& frame, const Outcomes& outcomes,
                     const EndedNodes& ended, const RejectionsStyle& style);

/// Whether there is nothing in it but the meshes behind.
bool shows_no_node(const Pane& pane);

/// Of the counts those that the filter lets through, and of the query's groups of endings those
/// that have such.
EndingCounts shown_counts(EndingCounts counts, const RejectionsStyle& style);
std::vector<EndingGroup> shown_groups(const TraceHeader& header, const RejectionsStyle& style);

/// The endings that are shown with their counts, and their shares of all. Without their colors
/// where colors are a scale.
std::vector<PanelItem> endings_legend(const TraceHeader& header, const TraceFrame& frame,
                                      const Outcomes& outcomes, const RejectionsStyle& style);

/// Both bodies' colors, and how many nodes of each are drawn.
std::vector<PanelItem> drawn_keys(const QueryBodies& bodies, const EndedNodes& ended,
                                  const RejectionsStyle& style);

/// What the color of a node tells, and what is left out.
std::vector<PanelItem> node_color_keys(const RejectionsStyle& style);

/// Its numbers and legend.
std::vector<PanelItem> rejections_panel(const QueryBodies& bodies, const TraceHeader& header,
                                        const TraceFrame& frame, const Outcomes& outcomes,
                                        const EndedNodes& ended, const RejectionsStyle& style);

/// How the tests of each depth of pairs ended, as stacked bars of what is shown.
PanelChart endings_chart(const TraceHeader& header, const TraceFrame& frame,
                         const Outcomes& outcomes, const RejectionsStyle& style);

}  // namespace scb::render
