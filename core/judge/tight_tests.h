#pragma once

#include "core/judge/query_check.h"

namespace scb {

/// The boxes of a tree, each drawn in to the triangles, or to the extents of objects, that are
/// below its node; other volumes as they are.
struct TightBoxes {
    std::vector<NodeVolume> volumes;  ///< per node
    std::uint64_t boxes = 0;          ///< nodes that have one, and something below
    std::uint64_t loose = 0;          ///< those of which a side is over 1.5 times what is needed
};

/// O(n) of boxes along the axes; of others O(n depth), up to some seconds of work, and then as they
/// are.
TightBoxes tight_boxes(const EngineSide& side);

/// How many tests of volumes the query would have made, in its own order, if its nodes had these
/// volumes: those that no test with disjoint volumes leads to. `tests` are those of the query.
std::uint64_t tests_with(const EngineQuery& query, std::span<const JudgedTest> tests,
                         const TightBoxes& of_a, const TightBoxes& of_b);

}  // namespace scb
