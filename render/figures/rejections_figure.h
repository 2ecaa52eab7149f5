#pragma once

#include <array>

#include "core/analysis/ended_paths.h"
#include "core/base/enum_names.h"
#include "render/figures/query_body.h"
#include "render/figures/scene_figure.h"
#include "render/plots/ending_colors.h"

namespace scb::render {

/// The color of a node at which paths ended: by one of its endings, or by the share of its tests
/// that rejected.
enum class NodeColor { first, last, dominant, share };

inline constexpr EnumNames<NodeColor, 4> node_color_names = {"first", "last", "dominant", "share"};

/// The style of the nodes at which the paths of a traversal ended.
struct RejectionsStyle {
    NodeColor by = NodeColor::dominant;
    EndedPathsFilter filter;
    std::array<bool, 2> sides = {true, true};  ///< which bodies
    bool nested = false;                       ///< also nodes that contain other drawn nodes
    /// The share of the ended paths that must be visible. The nodes with the fewest paths per
    /// squared size are left out, as long as their paths are at most the remaining share. Large
    /// volumes end few paths, and hide many.
    double focus = 1;
    double opacity = 1;  ///< of the volumes
    const Theme* theme = &light_theme;
};

/// The nodes at which paths of a query ended, of both bodies; empty on a side that is not shown.
using EndedNodes = std::array<std::vector<EndedPaths>, 2>;
EndedNodes ended_nodes(const QueryBodies& bodies, const QueryTrace& frame, const Outcomes& outcomes,
                       const RejectionsStyle& style);

/// Each node at which paths ended, in its ending's color, and hatched for B: as its exact volume,
/// or, if its triangles were tested, as these. Behind them, faint, are the meshes; in front of all
/// are the lines in which triangles meet, of `contact`, see contact_segments.
Pane rejections_pane(const QueryBodies& bodies, const QueryTrace& frame, const Outcomes& outcomes,
                     const EndedNodes& ended, std::vector<Segment> contact,
                     const RejectionsStyle& style);

/// Whether it has only the meshes in the background.
bool shows_no_node(const Pane& pane);

/// The counts that pass the filter, and the query's groups of endings with such counts.
EndingCounts shown_counts(EndingCounts counts, const RejectionsStyle& style);
std::vector<EndingGroup> shown_groups(const TraceHeader& header, const RejectionsStyle& style);

/// The shown endings with their counts, and their shares of all. Without their colors if colors are
/// a scale.
std::vector<PanelItem> endings_legend(const TraceHeader& header, const Outcomes& outcomes,
                                      const RejectionsStyle& style);

/// Both bodies' colors, and the numbers of their drawn nodes.
std::vector<PanelItem> drawn_keys(const QueryBodies& bodies, const EndedNodes& ended,
                                  const RejectionsStyle& style);

/// The meaning of a node's color, and the omitted nodes.
std::vector<PanelItem> node_color_keys(const RejectionsStyle& style);

/// Its numbers and legend.
std::vector<PanelItem> rejections_panel(const QueryBodies& bodies, const TraceHeader& header,
                                        const QueryTrace& frame, const Outcomes& outcomes,
                                        const EndedNodes& ended, const RejectionsStyle& style);

/// The endings of the tests at each depth of pairs, as stacked bars of the shown endings.
PanelChart endings_chart(const TraceHeader& header, const QueryTrace& frame,
                         const Outcomes& outcomes, const RejectionsStyle& style);

}  // namespace scb::render
