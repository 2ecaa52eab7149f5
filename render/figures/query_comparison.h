#pragma once

#include <array>
#include <optional>

#include "core/analysis/triangle_heat.h"
#include "render/figures/comparison_figure.h"
#include "render/figures/pairs_figure.h"
#include "render/figures/rejections_figure.h"

namespace scb::render {

/// One of two compared queries: of the same bodies at the same poses.
struct ComparedQuery {
    QueryBodies bodies;  ///< with the same ids as the other's, ids of triangles after all ids of
                         ///< nodes
    const TraceHeader* header = nullptr;
    const QueryTrace* frame = nullptr;
    std::vector<Segment> contact;  ///< see contact_segments
};
using ComparedQueries = std::array<ComparedQuery, 2>;

/// The pairs that only one of them found: [0] the first, [1] the second; sorted.
using PairsOfOne = std::array<std::vector<IndexPair>, 2>;
PairsOfOne pairs_of_one(const ComparedQueries& queries);

/// The views of pairs_figure, rejections_figure and heat_figure for each query, with the counts of
/// both and the differences of the second's. Differences between the views are outlined; nodes only
/// if both hierarchies have the same splits. Cameras and captions are not set. Pairs that only one
/// of them found have a color of their own in both views, and a remark. Heat has one scale for
/// both. The segments of the first query's pairs have the ids from `first_pair_id`, followed by the
/// second's.
std::array<ComparedView, 2> compared_pairs(const ComparedQueries& queries,
                                           const PairsOfOne& only_here, const PairsStyle& style,
                                           std::uint32_t first_pair_id);
std::array<ComparedView, 2> compared_rejections(const ComparedQueries& queries,
                                                const PairsOfOne& only_here,
                                                const RejectionsStyle& style);
std::array<ComparedView, 2> compared_heat(const ComparedQueries& queries,
                                          const PairsOfOne& only_here, HeatOf of,
                                          std::optional<std::uint32_t> scale_end,
                                          const Theme& theme);

/// The most rows that the panels of these need, for any frame.
ComparisonRows compared_pairs_rows(const PairsStyle& style);
ComparisonRows compared_rejections_rows(const TraceHeader& a, const TraceHeader& b,
                                        const RejectionsStyle& style);
ComparisonRows compared_heat_rows();

}  // namespace scb::render
