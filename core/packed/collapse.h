#pragma once

#include <cstdint>
#include <vector>

#include "scb/topology.h"

namespace scb {

/// A binary topology seen as a wide one: nodes with up to `width` children, and leaves of up to
/// `leaf_triangles` triangles. All are nodes of the binary one.
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

    std::vector<Node> nodes;  ///< parents first; empty where the root is a leaf
    std::vector<Child> children;
};

/// Chooses the wide topology that costs least, where a visit of a node costs its `cost`, and a leaf
/// costs what its node costs, once, however many triangles it has. (Charged for each triangle, with
/// weights from 0.1 to 1 of a node's cost, leaves become smaller: scans then take up to 1.5 times
/// the query time and 1.7 times the memory, soups of parts and knots 0.6 to 1.1 times the time.)
/// Costs are chances that a query gets there, up to a factor, such as surface areas. By dynamic
/// programming over the binary topology, after Ylitie, Karras and Laine, "Efficient Incoherent Ray
/// Traversal on GPUs Through Compressed Wide BVHs" (Section 3). O(n width^2); the same for any
/// number of threads.
///
/// `width` is 2 to 8, `leaf_triangles` at least 1; a binary node of at most so many triangles may
/// become a leaf, one of a single triangle always does.
WideTopology collapse(const Topology& topology, const std::vector<float>& cost, int width,
                      int leaf_triangles, int threads = 1);

}  // namespace scb
