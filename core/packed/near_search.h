#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "core/packed/packed_query.h"

namespace scb {

/// A traversal that looks for near triangles, and the query that decides which of them count.
struct NearSearch {
    /// Pairs of volumes and triangles whose bound is above it do not matter. `take` may lower it.
    float limit = 0;
    /// Whether the rest does not matter, either. `take` may set it.
    bool is_done = false;
    /// Receives a pair of triangles whose distance is at least `least` and at most `most`.
    std::function<void(IndexPair, float least, float most)> take;

    std::uint64_t n_v = 0,  ///< pairs of volumes whose bound was computed
        n_bounded = 0;      ///< pairs of triangles whose distance was bounded
};

/// Traverses the hierarchies. `heap`: the size of the heap, see LeastFirst; 0 to go depth first.
void find_near(const AnyPackedQuery& nodes, const LeafQuery& leaves, SimdLevel level,
               std::size_t heap, NearSearch& search);

/// The distances that triangle_distance returns for these pairs. None of them may intersect.
void distances_apart(const Mesh& a, const Mesh& b, const Pose& b_to_a, SimdLevel level,
                     std::span<const IndexPair> pairs, double* distances);

}  // namespace scb
