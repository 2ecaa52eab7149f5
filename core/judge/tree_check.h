#pragma once

#include <algorithm>

#include "core/model/engine_nodes.h"
#include "scb/mesh.h"

namespace scb {

/// What can be wrong with a tree. Up to `no_volume` it is its shape and does not change from frame
/// to frame.
enum class TreeFault {
    told_twice,        ///< `node` was described before
    missing_child,     ///< `node` lists `other`, which is not described
    listed_twice,      ///< `node` is a child of two nodes, or of its own descendant: `other` is the
                       ///< second that lists it
    wrong_parent,      ///< `node` says that its parent is `other`, and another lists it
    dropped,           ///< `node` says that its parent is `other`, which does not list it
    unreachable,       ///< no root leads to `node`, which is in or below a cycle
    triangle_nowhere,  ///< no node that a root leads to has `item`
    triangle_unknown,  ///< `node` has `item`, which the mesh does not
    triangle_broken,   ///< `item` has the vertex `other`, which is not finite
    bad_volume,        ///< of `node`: see EngineNodes::volume_fault
    no_volume,         ///< `node` has none, where others do
    outside,       ///< `item`, or the volume of the child `other`, is `amount` outside of `node`
    part_outside,  ///< a part of `item` is in none of the leaves that have it; the nearest is below
                   ///< `node`, `amount` away
};
inline constexpr std::size_t tree_fault_count = 13;

struct TreeProblem {
    TreeFault fault{};
    /// Numbers, as the tree has them; no_index where there is none.
    std::uint32_t node = no_index, other = no_index, item = no_index;
    double amount = 0;  ///< a length
    /// Of outside: a node below this one misses each of the items, too.
    bool inherited = false;

    friend bool operator==(const TreeProblem&, const TreeProblem&) = default;
};

/// Checks what does not depend on volumes. `mesh`: nullptr where items are no triangles.
std::vector<TreeProblem> check_shape(const EngineNodes& tree, const TreeShape& shape,
                                     const Mesh* mesh);

/// The length up to which an engine's arithmetic may be off, by the reach of a node's volume.
struct NodeTolerance {
    double least = 0, share = 0;

    NodeTolerance(double length) : least(length) {}  // NOLINT: the same length for all nodes
    NodeTolerance(double of_least, double of_reach) : least(of_least), share(of_reach) {}
    double of(double reach) const { return std::max(least, share * reach); }
    double of(const EngineNode& node) const { return of(node.reach); }
};

/// What of the volumes of a tree could not be judged.
struct UnjudgedVolumes {
    /// Leaves of objects whose own extents were not recorded, and how many leaves there are.
    std::uint64_t leaves = 0, of_leaves = 0;
    /// Boxes along the axes that do not contain what is below them, by more than one unit in the
    /// last place of 32-bit numbers, but by less than the tolerance; by how much at most.
    std::uint64_t slightly_open = 0;
    double open_by = 0;
    /// Triangles without an area that no leaf has.
    std::uint64_t dropped = 0;
    /// Triangles in several leaves, see TriangleCover::undecided, and how many are in several.
    std::uint64_t splits = 0, of_splits = 0;
};

/// Checks all volumes: that there are some, and that each contains, but for `tolerance`, the
/// triangles of all nodes below it; of a tree without mesh, the volumes of its children, where a
/// few directions tell, and the extents of objects. A triangle in several leaves must be in all of
/// them together, see cover_of. One problem per node, that of the greatest amount; the nodes
/// farthest from the root first. O(n) where the box of what is below shows that it is contained,
/// else O(n depth).
std::vector<TreeProblem> check_volumes(const EngineNodes& tree, const TreeShape& shape,
                                       const Mesh* mesh, NodeTolerance tolerance,
                                       UnjudgedVolumes* unjudged = nullptr);

/// How far the child reaches beyond the parent, at least.
double reach_beyond(const ConvexShape& parent, const ConvexShape& child);

/// A length, which may be infinite.
std::string amount_words(double length);

/// The problem as a sentence that begins with the node: "node 7 does not contain triangle 12 by
/// 0.03."
std::string words_of(const TreeProblem& problem, const EngineNodes& tree);

}  // namespace scb
