#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/hierarchy/tree_shape.h"
#include "core/model/engine_nodes.h"
#include "core/volumes/any_volume.h"
#include "scb/any_hierarchy.h"

namespace scb {

/// The type of a tree's volumes, for words about their lengths.
enum class VolumeFamily { slab_cut, two_slabs, ball, box, convex };

/// A bounding volume hierarchy, built by this project or by an engine, as pictures, files and
/// reports read it. Nodes go by their index; volumes are in the body's frame.
class Tree {
  public:
    /// Refers to the hierarchy, which must outlive the tree.
    explicit Tree(const AnyHierarchy& hierarchy);
    /// The tree of an engine. `shape` is tree_shape of its nodes. Boxes without an end are cut a
    /// bit outside of the other volumes.
    Tree(EngineNodes nodes, TreeShape shape);

    const TreeShape& shape() const { return shape_; }
    std::size_t size() const { return shape_.size(); }
    bool is_leaf(std::uint32_t node) const { return shape_.is_leaf(node); }

    /// Whether the node has a volume; an engine's nodes may have none.
    bool has_volume(std::uint32_t node) const;
    /// The volume of a node that has one.
    AnyVolume volume(std::uint32_t node) const;
    VolumeLengths lengths(std::uint32_t node) const;
    VolumeSize volume_size(std::uint32_t node) const;
    /// Whether the volume contains a point, with all its faces moved outward by `slack`.
    bool contains(std::uint32_t node, const Vec3& point, double slack) const;

    VolumeFamily family() const;
    /// The triangles, or objects, of the node itself.
    std::span<const std::uint32_t> items(std::uint32_t node) const;
    /// The number that the builder gives the node. Users see numbers, never indices.
    std::uint32_t number(std::uint32_t node) const;
    /// The node of a number; no_index if there is none.
    std::uint32_t node_of(std::uint32_t number) const;
    /// The engine's name of the node; mostly empty.
    std::string name(std::uint32_t node) const;
    /// "node 412", and the engine's name of the node in quotes.
    std::string node_words(std::uint32_t node) const;
    /// Whether the number of some node differs from its index.
    bool has_own_numbers() const;

    /// Equal for trees with the same links and items, regardless of volumes.
    std::uint64_t hash() const;

  private:
    template <class Result, class Measure>
    Result measured(std::uint32_t node, const Measure& measure) const;

    TreeShape shape_;
    std::variant<const AnyHierarchy*, EngineNodes> nodes_;
};

/// The name of a volume's type in titles: "OBB", "AABB", "hull"; a box with the axes of its body is
/// an AABB. Empty if there is no volume.
std::string volume_title(const NodeVolume& volume);

/// The names of the types of a tree's volumes in titles: "OBB", "AABB", "hull".
std::vector<std::string> volumes_titles(const EngineNodes& nodes);

}  // namespace scb
