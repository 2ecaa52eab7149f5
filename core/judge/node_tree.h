#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/hierarchy/tree_shape.h"
#include "core/judge/node_volume.h"

namespace scb {

/// A node as its engine tells of it: nothing of it need be true.
struct TreeNode {
    std::uint32_t number = 0;         ///< by which the engine's tests name it
    std::uint32_t parent = no_index;  ///< the parent's number
    std::uint64_t id = 0;             ///< what the engine calls it
    std::uint32_t first_child = 0, child_count = 0, first_item = 0, item_count = 0;
    NodeVolume volume;
    double reach = 0;  ///< the largest |number| of the volume that is a length
    int told_at = 0;   ///< the frame from which on it has this volume
    int links_at = 0;  ///< the frame from which on it has these children and items
};

/// A tree of nodes with any number of children, of whatever engine; what it was told of may be no
/// tree at all. Indices go by the order in which nodes were told. Items are triangles of a mesh, or
/// objects that nothing is known of.
class NodeTree {
  public:
    std::string name;
    bool has_objects = false;  ///< items are objects, not triangles

    /// `node.first_child` to `node.item_count` are set here. The second node of a number is not
    /// taken.
    void add(TreeNode node, std::string node_name, std::span<const std::uint32_t> children,
             std::span<const std::uint32_t> items);

    /// The parent, children and items of a node from this frame on.
    void relink(std::uint32_t index, std::uint32_t parent, int frame,
                std::span<const std::uint32_t> children, std::span<const std::uint32_t> items);

    std::size_t size() const { return nodes_.size(); }
    const TreeNode& operator[](std::size_t index) const { return nodes_[index]; }
    TreeNode& operator[](std::size_t index) { return nodes_[index]; }
    /// no_index where there is none of this number.
    std::uint32_t index_of(std::uint32_t number) const;
    /// The number of its parent as it tells it; no_index where it tells of none: a root, or any
    /// node where all name the same one, as of an engine that knows no parents.
    std::uint32_t parent(std::size_t index) const;
    /// The numbers of its children as it tells them.
    std::span<const std::uint32_t> children(std::size_t index) const;
    std::span<const std::uint32_t> items(std::size_t index) const;
    /// The engine's own name of the node; empty where it has none.
    std::string name_of(std::size_t index) const;
    /// "node 12", with that name in quotes.
    std::string words(std::size_t index) const;
    /// The numbers of nodes that were told again, in that order.
    const std::vector<std::uint32_t>& told_twice() const { return told_twice_; }

    /// The volume from this frame on. `fault`: why what was told is none, as a clause; else empty.
    void set_volume(std::uint32_t index, NodeVolume volume, int frame, std::string fault,
                    double reach = 0);
    /// Why the node has none; empty where it has one, or was told to have none.
    std::string volume_fault(std::uint32_t index) const;

    /// The extent of an object, in the tree's frame, from now on.
    void set_object_volume(std::uint32_t object, NodeVolume volume);
    /// nullptr where none was recorded.
    const NodeVolume* object_volume(std::uint32_t object) const;
    /// Changes all volumes, those of nodes and those of objects.
    void change_volumes(const std::function<NodeVolume(const NodeVolume&)>& change);

  private:
    std::vector<TreeNode> nodes_;
    std::vector<std::uint32_t> children_, items_, told_twice_;
    bool tells_parents_ = false;  ///< not all are the same
    std::unordered_map<std::uint32_t, std::uint32_t> by_number_;
    std::unordered_map<std::uint32_t, std::string> names_, volume_faults_;  ///< by index
    std::map<std::uint32_t, NodeVolume> object_volumes_;
};

/// `items` is how many there are: those of higher numbers are left out.
TreeShape tree_shape(const NodeTree& tree, std::size_t items);

}  // namespace scb
