#pragma once

#include <algorithm>

#include "core/model/engine_nodes.h"
#include "scb/mesh.h"

namespace scb {

/// What can be wrong with a tree. The faults before `bad_volume` concern its links and items, see
/// check_shape.
enum class TreeFault {
    recorded_twice,    ///< `node` was described before
    missing_child,     ///< `node` lists `other`, which is not described
    listed_twice,      ///< `node` is a child of two nodes, or of its own descendant: `other` is the
                       ///< second that lists it
    wrong_parent,      ///< `node` names `other` as its parent, but another node lists it
    dropped,           ///< `node` names `other` as its parent, which does not list it
    unreachable,       ///< `node` is not reachable from a root: it is in or below a cycle
    triangle_nowhere,  ///< no reachable node has `item`
    triangle_unknown,  ///< `node` has `item`, which the mesh does not have
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
    /// Numbers of nodes, and an item; no_index if there is none.
    std::uint32_t node = no_index, other = no_index, item = no_index;
    double amount = 0;  ///< a length
    /// `outside`: each of the items is also outside of a node below this one.
    bool inherited = false;

    friend bool operator==(const TreeProblem&, const TreeProblem&) = default;
};

/// Checks what does not depend on volumes. `mesh`: nullptr where items are no triangles.
std::vector<TreeProblem> check_shape(const EngineNodes& tree, const TreeShape& shape,
                                     const Mesh* mesh);

/// The assumed rounding error of an engine, as a length, by the reach of a node's volume.
struct NodeTolerance {
    double least = 0, share = 0;

    NodeTolerance(double length) : least(length) {}  // NOLINT: the same length for all nodes
    NodeTolerance(double of_least, double of_reach) : least(of_least), share(of_reach) {}
    double of(double reach) const { return std::max(least, share * reach); }
    double of(const EngineNode& node) const { return of(node.reach); }
};

/// The volumes of a tree that could not be judged.
struct UnjudgedVolumes {
    /// Leaves of objects whose extents were not recorded, and all leaves of objects.
    std::uint64_t leaves = 0, of_leaves = 0;
    /// Boxes along the axes that miss items below them by more than a 32-bit unit in the last
    /// place, but by less than the tolerance; and the greatest such length.
    std::uint64_t slightly_open = 0;
    double open_by = 0;
    /// Triangles without area that no leaf has.
    std::uint64_t dropped = 0;
    /// Triangles in several leaves for which TriangleCover is undecided, and all in several leaves.
    std::uint64_t splits = 0, of_splits = 0;
};

/// Checks that all nodes have a volume, if one has, and that each volume contains, within
/// `tolerance`, all triangles below its node. Without a mesh, checks the recorded extents of
/// objects and, where they are missing, the boxes of child nodes. A triangle in several leaves must
/// be covered by them together, see cover_of. Returns one problem per node, the one with the
/// greatest amount, deepest nodes first. O(n) if boxes of the items show that all is contained,
/// else O(n depth).
std::vector<TreeProblem> check_volumes(const EngineNodes& tree, const TreeShape& shape,
                                       const Mesh* mesh, NodeTolerance tolerance,
                                       UnjudgedVolumes* unjudged = nullptr);

/// A lower bound of how far the child reaches beyond the parent.
double reach_beyond(const ConvexShape& parent, const ConvexShape& child);

/// The length in words; it may be infinite.
std::string amount_words(double length);

/// The problem as a sentence that begins with the node: "node 7 does not contain triangle 12 by
/// 0.03."
std::string words_of(const TreeProblem& problem, const EngineNodes& tree);

}  // namespace scb
