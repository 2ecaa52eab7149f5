#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/hierarchy/tree_shape.h"
#include "core/volumes/any_volume.h"
#include "scb/any_hierarchy.h"

namespace scb {

/// What the volumes of a tree are, for words about their lengths.
enum class VolumeFamily { slab_cut, two_slabs, ball, box, convex };

/// A bounding volume hierarchy of whatever builder, as pictures, files and reports read it. Nodes
/// go by their index; volumes are in the body's frame.
class VolumeTree {
  public:
    explicit VolumeTree(TreeShape shape) : shape_(std::move(shape)) {}
    virtual ~VolumeTree() = default;

    const TreeShape& shape() const { return shape_; }
    std::size_t size() const { return shape_.size(); }
    bool is_leaf(std::uint32_t node) const { return shape_.is_leaf(node); }

    /// Whether a node has one: those of other engines need not.
    virtual bool has_volume(std::uint32_t node) const = 0;
    /// Those of a node that has one.
    virtual AnyVolume volume(std::uint32_t node) const = 0;
    virtual VolumeLengths lengths(std::uint32_t node) const = 0;
    virtual VolumeSize volume_size(std::uint32_t node) const = 0;
    /// Whether it contains a point, with all its faces moved outward by `slack`.
    virtual bool contains(std::uint32_t node, const Vec3& point, double slack) const = 0;

    virtual VolumeFamily family() const = 0;
    /// The triangles, or objects, of the node itself.
    virtual std::span<const std::uint32_t> items(std::uint32_t node) const = 0;
    /// The number by which its builder calls the node: users see it, and no index.
    virtual std::uint32_t number(std::uint32_t node) const { return node; }
    /// The node of such a number; no_index where there is none.
    virtual std::uint32_t node_of(std::uint32_t number) const {
        return number < size() ? number : no_index;
    }
    /// What its builder calls the node besides; mostly empty.
    virtual std::string name(std::uint32_t) const { return {}; }
    /// "node 412", with its name in quotes where it has one.
    std::string node_words(std::uint32_t node) const;
    /// Whether some node has another number than its index.
    bool has_own_numbers() const;

  protected:
    VolumeTree(const VolumeTree&) = default;
    VolumeTree& operator=(const VolumeTree&) = default;

  private:
    TreeShape shape_;
};

/// The hierarchy, which must outlive the result.
std::unique_ptr<VolumeTree> volume_tree(const AnyHierarchy& hierarchy);

}  // namespace scb
