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
#include "core/model/node_volume.h"

namespace scb {

/// A recorded node, not validated; see judge/tree_check.h for contradictions.
struct EngineNode {
    std::uint32_t number = 0;         ///< the node's name in tests
    std::uint32_t parent = no_index;  ///< the parent's number
    std::uint64_t id = 0;             ///< the engine's own identity of the node
    std::uint32_t first_child = 0, child_count = 0, first_item = 0, item_count = 0;
    NodeVolume volume;
    double reach = 0;     ///< the largest |number| of the volume that is a length
    int recorded_at = 0;  ///< the first frame with this volume
    int links_at = 0;     ///< the first frame with these children and items
};

/// The nodes of an engine's tree, as recorded: with any number of children, and perhaps no tree at
/// all. Indices follow the order of the records. Items are triangles of a mesh, or objects of
/// unknown shape.
class EngineNodes {
  public:
    std::string name;
    bool has_objects = false;  ///< items are objects, not triangles

    /// Adds a node and sets `node.first_child` to `node.item_count`. A second node of the same
    /// number is only noted, see recorded_twice.
    void add(EngineNode node, std::string node_name, std::span<const std::uint32_t> children,
             std::span<const std::uint32_t> items);

    /// Replaces the parent, children and items of a node from this frame on.
    void relink(std::uint32_t index, std::uint32_t parent, int frame,
                std::span<const std::uint32_t> children, std::span<const std::uint32_t> items);

    std::size_t size() const { return nodes_.size(); }
    const EngineNode& operator[](std::size_t index) const { return nodes_[index]; }
    EngineNode& operator[](std::size_t index) { return nodes_[index]; }
    /// The index of a number; no_index if no node has it.
    std::uint32_t index_of(std::uint32_t number) const;
    /// The recorded number of the parent; no_index for roots, and for all nodes if all have the
    /// same parent, as recorded by engines without parents.
    std::uint32_t parent(std::size_t index) const;
    /// The recorded numbers of the children.
    std::span<const std::uint32_t> children(std::size_t index) const;
    std::span<const std::uint32_t> items(std::size_t index) const;
    /// The engine's own name of the node; empty if it has none.
    std::string name_of(std::size_t index) const;
    /// "node 12", with that name in quotes.
    std::string words(std::size_t index) const;
    /// The numbers of nodes that were recorded again, in the order of the records.
    const std::vector<std::uint32_t>& recorded_twice() const { return recorded_twice_; }

    /// Sets the volume from this frame on. `fault`: why the recorded numbers are no volume, as a
    /// clause; empty if they are one.
    void set_volume(std::uint32_t index, NodeVolume volume, int frame, std::string fault,
                    double reach = 0);
    /// Why the recorded numbers are no volume; empty if they are one, or if none was recorded.
    std::string volume_fault(std::uint32_t index) const;

    /// The extent of an object, in the tree's frame, from now on.
    void set_object_volume(std::uint32_t object, NodeVolume volume);
    /// The extent of an object; nullptr if none was recorded.
    const NodeVolume* object_volume(std::uint32_t object) const;
    /// Changes all volumes of nodes and objects.
    void change_volumes(const std::function<NodeVolume(const NodeVolume&)>& change);

  private:
    std::vector<EngineNode> nodes_;
    std::vector<std::uint32_t> children_, items_, recorded_twice_;
    bool has_parents_ = false;  ///< the recorded parents differ
    std::unordered_map<std::uint32_t, std::uint32_t> by_number_;
    std::unordered_map<std::uint32_t, std::string> names_, volume_faults_;  ///< by index
    std::map<std::uint32_t, NodeVolume> object_volumes_;
};

/// The links of the nodes that a root reaches. `items`: the number of items; higher item numbers
/// are left out.
TreeShape tree_shape(const EngineNodes& tree, std::size_t items);

}  // namespace scb
