#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "scb/stage.h"

namespace scb {

/// Two triangles, or two nodes, by their indices in A and in B.
struct IndexPair {
    std::uint32_t a = 0, b = 0;
    friend auto operator<=>(const IndexPair&, const IndexPair&) = default;
};

/// What a query found and what it took. The symbols are those of equation 1 of the paper.
struct Collision {
    std::vector<IndexPair> pairs;  ///< triangles that intersect, or nodes of `stop_level` that
                                   ///< overlap; sorted, each once
    std::uint64_t n_v = 0;         ///< tests of two volumes, those of two leaves among them
    std::uint64_t n_p = 0;         ///< tests of two triangles
    std::uint64_t n_u = 0;         ///< points and directions of volumes transformed for these tests
    StageCounts stages{};          ///< volume tests by how they ended; their sum is n_v
    int depth = 0;         ///< of the deepest volume test: depth of its node of A plus that of B
    bool complete = true;  ///< false where `max_pairs` ended the query: there may be more
};

}  // namespace scb
