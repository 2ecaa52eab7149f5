#pragma once

#include <optional>

#include "core/analysis/attribution.h"
#include "render/figures/query_body.h"
#include "render/plots/ending_colors.h"
#include "render/web/block_store.h"

namespace scb::render {

/// The tests of a query, and what it found.
struct QueryBlocks {
    /// Number of a block: of each test of volumes, in their order, u8. The lower six bits: 0 where
    /// the children of A's node or of both nodes were tested next, 1 where the children of B's node
    /// were, else 2 and the index of its ending's group. Bit 6: it passed volumes that are
    /// disjoint, or rejected some that overlap or hold triangles that intersect. Bit 7: triangles
    /// below it intersect, and no test that followed says so.
    std::size_t outcomes = 0;
    /// Per step A's node, B's node and the parent, n x 3, u32; 2^32 - 1: no parent. Nothing where
    /// the page predicts all of them from the outcomes: first the roots, then all children of the
    /// pair that was divided last.
    std::optional<std::size_t> nodes;
    std::size_t pairs = 0;  ///< of triangles, u32
};

/// `groups` are the header's groups, see ending_groups. Of `bodies` the trees are needed.
QueryBlocks query_blocks(const QueryBodies& bodies, const QueryTrace& frame,
                         const Outcomes& outcomes, const Attribution& attribution,
                         const std::vector<EndingGroup>& groups, BlockStore& store);

}  // namespace scb::render
