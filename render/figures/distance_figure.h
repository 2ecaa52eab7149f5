#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/analysis/distance_steps.h"
#include "render/figures/query_body.h"
#include "render/figures/scene_figure.h"
#include "render/plots/ending_colors.h"

namespace scb::render {

/// The meaning of a group of endings in legends. Some endings mean other things in a query of
/// distances than in other queries.
std::string ending_words(const EndingGroup& group, QueryKind kind);

/// A distance with six digits.
std::string distance_text(double value);

/// By pair that a query of distances found, the closest points in A's frame. Of triangles that
/// intersect, the ends of the line in which they meet.
std::vector<std::array<Vec3, 2>> distance_lines(const QueryBodies& bodies, const QueryTrace& frame);

/// The lines between the closest points of the pairs that a query of distances found, in the world.
/// Of triangles that intersect, the line in which they meet. The id of each is the index of its
/// pair.
std::vector<Segment> distance_segments(const QueryBodies& bodies, const QueryTrace& frame);

/// The distance as a label on its line; none if bodies intersect.
std::vector<SceneLabel> distance_labels(const QueryBodies& bodies, const QueryTrace& frame,
                                        const Theme& theme);

/// The distance that a query found.
PanelItem distance_row(const QueryTrace& frame);

/// The meaning of the lines of an answer.
PanelKey distance_key(const TraceHeader& header, const QueryTrace& frame, const Theme& theme);

/// The distance with its triangles, or the number of pairs within the tolerance; the counts; and
/// how many pairs of volumes were left out, by the direction of the largest bound. `verdicts`: on
/// the query's tests, see tested_pairs; it says how many pairs were divided in vain.
std::vector<PanelItem> distance_panel(const QueryBodies& bodies, const TraceHeader& header,
                                      const QueryTrace& frame, const Attribution& verdicts,
                                      const Theme& theme);

/// The pairs of volumes by depth, in the colors of the panel.
PanelChart distance_chart(const TraceHeader& header, const QueryTrace& frame, const Theme& theme);

}  // namespace scb::render
