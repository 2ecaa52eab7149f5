#pragma once

#include <cstdint>
#include <vector>

#include "scb/topology.h"

namespace scb {

/// A wide topology over a binary one: nodes with up to `width` children, and leaves of up to
/// `leaf_triangles` triangles. Each is a node of the binary topology.
struct WideTopology {
    struct Node {
        std::uint32_t node = 0;         ///< of the binary topology
        std::uint32_t first_child = 0;  ///< in `children`
        std::uint32_t child_count = 0;
    };
    struct Child {
        std::uint32_t node = 0;  ///< of the binary topology
        std::uint32_t wide = 0;  ///< in `nodes`; no_node: a leaf
    };
    static constexpr std::uint32_t no_node = ~std::uint32_t{0};

    std::vector<Node> nodes;  ///< parents first; empty if the root is a leaf
    std::vector<Child> children;
};

/// Chooses the wide topology of least cost. A visit of a node costs its `cost`; a leaf costs as
/// much as its node, regardless of the number of its triangles. (If each triangle costs 0.1 to 1
/// times as much as a node, leaves become smaller: scans then take up to 1.5 times the query time
/// and 1.7 times the memory, soups of parts and knots 0.6 to 1.1 times the time.) Costs are
/// probabilities of visits, up to a factor, such as surface areas. By dynamic programming over the
/// binary topology, after Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs
/// Through Compressed Wide BVHs" (Section 3). O(n width^2); the same for any number of threads.
///
/// `width` is 2 to 8, `leaf_triangles` at least 1. A binary node of at most `leaf_triangles`
/// triangles may become a leaf; single triangles always do.
WideTopology collapse(const Topology& topology, const std::vector<float>& cost, int width,
                      int leaf_triangles, int threads = 1);

}  // namespace scb
