#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/traversal_tree.h"
#include "render/plots/ending_colors.h"
#include "scb/event_recorder.h"

namespace scb::render {

/// Neighboring columns of one row of an icicle that look alike.
struct IcicleRun {
    static constexpr std::uint32_t divided = 0xffffffff;
    static constexpr std::uint32_t several = 0xffffffff;

    int row = 0;
    int begin = 0, end = 0;   ///< columns: end is the first one behind
    std::uint32_t group = 0;  ///< index of the endings' group, or `divided`
    std::uint32_t test = 0;   ///< index of the only volume test there, or `several`
};

/// The recursion of a traversal as an icicle (Kruskal and Landwehr, "Icicle Plots", The American
/// Statistician 37, 1983): every volume test is a rectangle one row below that of the pair whose
/// division led to it. Its width is the share of all tests that begin with it (subtree_sizes), and
/// the children of a pair lie below its left end, in the order in which they were tested; what is
/// left at its right end is the pair's own test.
///
/// A column of a row that several tests touch shows the outcome of some of them, such that along
/// the row the outcomes appear in proportion: every column gives each outcome credit for its share
/// of the tests that touch the column, takes the one with the most credit among those that occur
/// there (of equal ones the first in the order of the groups, pairs that were divided last), and
/// charges it for a column. (The most frequent one would hide what is rejected: half of all pairs
/// are divided.)
struct Icicle {
    int columns = 0;
    int rows = 0;
    int depths_per_row = 1;       ///< more than 1 where there are more depths than rows
    std::vector<IcicleRun> runs;  ///< row by row, from left to right
};

/// Of a query's events and their tree; `groups` must have all endings that occur. `columns` and
/// `most_rows` are at least 1.
Icicle icicle(const Events& events, const TraversalTree& tree,
              const std::vector<EndingGroup>& groups, int columns, int most_rows);

}  // namespace scb::render
