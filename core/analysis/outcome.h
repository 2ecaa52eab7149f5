#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "scb/step.h"

namespace scb {

/// What became of a pair of nodes whose volumes were tested. Values from 1 to stage_count - 1
/// are the stages at which the test rejected the pair, see rejected_at. A path of the traversal
/// ends with every outcome but the last three, see is_divided.
enum class Outcome : std::uint8_t {
    triangles_apart = stage_count,  ///< two leaves that overlap, whose triangles do not intersect
    triangles_meet,                 ///< two leaves that overlap, whose triangles intersect
    found,                          ///< nodes that overlap at the level where the query stopped
    neighbors,     ///< two leaves that overlap, whose triangles share a vertex, in a self query
    left_over,     ///< they overlap, but the query had its pairs before it came to divide them
    divided_a,     ///< they overlap; the children of A's node were tested next
    divided_b,     ///< they overlap; the children of B's node were tested next
    divided_both,  ///< they overlap; the children of both were: other engines do so
};
/// How many outcomes end a path, and indices below which they are: but for foreign stages.
inline constexpr std::size_t ending_count = stage_count + 5;
/// Above all outcomes.
inline constexpr std::size_t outcome_end = 192;

constexpr Outcome rejected_at(Stage stage) { return static_cast<Outcome>(stage); }
constexpr bool is_rejection(Outcome outcome) {
    return (outcome != Outcome{} && static_cast<std::size_t>(outcome) < stage_count) ||
           is_foreign(static_cast<Stage>(outcome));
}
constexpr bool is_divided(Outcome outcome) {
    return outcome >= Outcome::divided_a && outcome <= Outcome::divided_both;
}
constexpr bool is_ending(Outcome outcome) {
    return static_cast<std::size_t>(outcome) < ending_count ||
           is_foreign(static_cast<Stage>(outcome));
}

/// "slab-cylinder", ... of rejections; "triangles apart", "triangles meet", "found", "neighbors",
/// "left over", "divided a", "divided b", "divided both". Foreign stages have no name, see
/// stage_words.
std::string_view outcome_name(Outcome outcome);

/// The outcome of each step of a query.
using Outcomes = std::vector<Outcome>;

/// The outcomes of a query's steps. `found_nodes` are its pairs, sorted, where these are pairs of
/// nodes, otherwise empty. O(n log n).
Outcomes outcomes_of(const Steps& steps, std::span<const IndexPair> found_nodes);

}  // namespace scb
