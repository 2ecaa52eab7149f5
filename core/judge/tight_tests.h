#pragma once

#include "core/judge/query_check.h"

namespace scb {

/// The volumes of a tree, with each box shrunk along its own axes to the triangles, or the extents
/// of objects, below its node. Other volumes are unchanged.
struct TightBoxes {
    std::vector<NodeVolume> volumes;  ///< per node
    std::uint64_t boxes = 0;          ///< boxes with something below
    std::uint64_t loose = 0;  ///< boxes with a side too long by over half the longest needed side
};

/// O(n) for boxes along the axes, O(n depth) for others. Oriented boxes stay unchanged if they
/// would take more than some seconds.
TightBoxes tight_boxes(const EngineSide& side);

/// The number of tests of volumes that the query would make if its nodes had these volumes. Tests
/// below a pair of disjoint volumes fall away. `tests`: the judged tests of the query.
std::uint64_t tests_with(const EngineQuery& query, std::span<const JudgedTest> tests,
                         const TightBoxes& of_a, const TightBoxes& of_b);

}  // namespace scb
