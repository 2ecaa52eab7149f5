#pragma once

#include <span>
#include <vector>

#include "core/analysis/trace.h"
#include "core/distance/contact_patches.h"
#include "render/figures/query_body.h"
#include "render/figures/scene_figure.h"
#include "render/figures/seeing_direction.h"

namespace scb::render {

/// The content of pictures of a query's result.
struct PairsStyle {
    bool leaves = false;   ///< show the leaf volumes that overlapped
    bool patches = false;  ///< number the contact patches; the pairs must be of triangles
    const Theme* theme = &light_theme;
};

/// The opacity of triangles in pairs and of areas where a body hides them.
inline constexpr double hidden_opacity = 0.3;

/// How many bodies a picture of the query shows: one of a self query.
std::size_t bodies_in(const TraceHeader& header);

/// The indices of a body in these pairs, ascending, each once. In a self query both sides belong to
/// the one body.
std::vector<std::uint32_t> in_pairs(const TraceHeader& header, std::vector<IndexPair> pairs,
                                    std::size_t side);

/// Of a query of distances: distance_segments. Else the segments in which the pairs of triangles
/// meet, in the world, without pairs that meet in an area; then the outlines of these areas. The id
/// of each is the index of its pair. Empty if the pairs are nodes.
std::vector<Segment> contact_segments(const QueryBodies& bodies, const TraceHeader& header,
                                      const QueryTrace& frame);

/// The result of a query: both meshes, pale; the triangles that intersect in the bodies' colors,
/// which shine through a body in front of them; the areas in which triangles lie on each other; the
/// segments in which they meet, dashed where a body hides them; and, on request,
/// translucent and hatched for B, the volumes of leaves that overlapped although their triangles do
/// not intersect. For a query that stopped at a level: the volumes of the pairs of nodes.
/// `contact`: of contact_segments. `first_pair_id` is the id of the first pair's segment.
Pane pairs_pane(const QueryBodies& bodies, const TraceHeader& header, const QueryTrace& frame,
                std::vector<Segment> contact, const PairsStyle& style, std::uint32_t first_pair_id);

/// For seeing_direction: where the bodies meet, hidden where a body is in front. The score is the
/// number of visible pixels of lines, areas and volumes, times the smaller number of visible pixels
/// of a body's triangles in pairs. So both bodies are to be seen.
Subject contact_subject(const QueryBodies& bodies, const TraceHeader& header,
                        const QueryTrace& frame, std::vector<Segment> contact);

/// Its numbers and legend. `patches`: of patches_of, if the style numbers them.
std::vector<PanelItem> pairs_panel(const QueryBodies& bodies, const TraceHeader& header,
                                   const QueryTrace& frame, const PairsStyle& style,
                                   std::span<const ContactPatch> patches = {});

/// The meaning of its colors.
std::vector<PanelItem> pairs_legend(const QueryBodies& bodies, const TraceHeader& header,
                                    const QueryTrace& frame, const PairsStyle& style);

/// The volumes that a camera following the contact must show: the ends of the segments in which
/// triangles meet, or the volumes of nodes. Empty without contact. `contact`: of contact_segments.
std::vector<AnyVolume> contact_region(const QueryBodies& bodies, const TraceHeader& header,
                                      const QueryTrace& frame, std::span<const Segment> contact);

}  // namespace scb::render
