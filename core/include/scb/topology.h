#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "scb/mesh.h"
#include "scb/simd_level.h"

namespace scb {

/// Which rule of Section 3 divided a node's triangles.
enum class SplitRule : std::uint8_t {
    leaf,          ///< one triangle: not divided
    longest_side,  ///< through the centroid of the box, across its longest side
    second_side,   ///< the same across the second longest side
    third_side,    ///< the same across the shortest side
    median_of_7,   ///< across the longest side, at the median of 7 randomly selected centroids
    sorted,        ///< fewer than 8 triangles: insertion sort along the longest side, halved
    index,  ///< all of the above were worse than 10 : 90: halved in the order of centroid, then
            ///< index
    least_cost,  ///< not of Section 3: see SplitMethod::cost
};
/// How many rules there are.
inline constexpr std::size_t split_rule_count = 8;

/// The rule in words, for tables: "longest side".
std::string_view split_rule_name(SplitRule rule);

/// A node: a range of `Topology::order`, and two consecutive children.
struct TopologyNode {
    std::uint32_t first = 0;  ///< start of the range in Topology::order
    std::uint32_t count = 0;  ///< triangles in the range, at least 1
    std::uint32_t left = 0;   ///< index of the left child, the right one is left + 1; 0 for a leaf

    /// Whether it has no children.
    bool is_leaf() const { return left == 0; }
};

/// The shape of a hierarchy, without volumes: a binary tree of ranges, one triangle per leaf.
/// nodes[0] is the root. n triangles make 2 n - 1 nodes. The 2 n - 2 nodes below a node of n
/// triangles follow each other from its left child on: the two children, then all nodes below the
/// left one, then all below the right one.
struct Topology {
    /// Parents before their children.
    std::vector<TopologyNode> nodes;
    std::vector<SplitRule> rules;      ///< per node
    std::vector<std::uint32_t> order;  ///< triangle indices, permuted
};

/// How nodes are divided.
enum class SplitMethod {
    section_3,  ///< by the rules of Section 3
    cost,       ///< where a surface area heuristic gives the least cost
};

/// "paper", "cost": the names of the command line.
std::string_view split_method_name(SplitMethod method);
/// The method with this name; no value if no method has the name.
std::optional<SplitMethod> split_method_of(std::string_view name);

/// How a tree is built.
struct TopologyOptions {
    /// How its nodes are divided.
    SplitMethod split = SplitMethod::section_3;
    /// How many threads; the result is the same for any number.
    int threads = 1;
    /// Which vector instructions to use; the result is the same for any.
    SimdLevel simd = SimdLevel::best;
};

/// Builds the tree top down. By the rules of Section 3, the primitives' box is divided through its
/// centroid across the longest side, by the centroids of the triangles; where a side gets less than
/// 10 %, across the other sides in turn, then at the median of 7 randomly selected centroids. If
/// that fails too (centroids that coincide), the middle index divides, so the depth is at most some
/// 6.6 log2 n for any input. The random numbers depend on the range alone.
///
/// `mesh` must satisfy check_mesh. O(n log n), with another log n where centroids coincide.
Topology build_topology(const Mesh& mesh, const TopologyOptions& options = {});

/// The depth of every node; the root has 0.
std::vector<std::uint16_t> node_depths(const Topology& topology);
/// The depth of one node. O(depth).
std::uint16_t node_depth(const Topology& topology, std::uint32_t node);

}  // namespace scb
