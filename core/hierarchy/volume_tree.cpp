#include "core/hierarchy/volume_tree.h"

#include <type_traits>

#include "core/volumes/measured_shape.h"

namespace scb {
namespace {

template <Volume V>
class OwnTree final : public VolumeTree {
  public:
    explicit OwnTree(const Hierarchy<V>& hierarchy)
        : VolumeTree(tree_shape(*hierarchy.topology)), hierarchy_(hierarchy) {}

    bool has_volume(std::uint32_t) const override { return true; }
    AnyVolume volume(std::uint32_t node) const override { return shape_of(of(node)); }
    VolumeLengths lengths(std::uint32_t node) const override { return lengths_of(of(node)); }
    VolumeSize volume_size(std::uint32_t node) const override { return size_of(of(node)); }
    bool contains(std::uint32_t node, const Vec3& point, double slack) const override {
        return scb::contains(enlarged(of(node), slack), point);
    }

    VolumeFamily family() const override {
        using Shape = std::decay_t<decltype(shape_of(std::declval<V>()))>;
        return std::is_same_v<Shape, Scb>    ? VolumeFamily::slab_cut
               : std::is_same_v<Shape, Scb2> ? VolumeFamily::two_slabs
               : std::is_same_v<Shape, Ball> ? VolumeFamily::ball
               : std::is_same_v<Shape, Obb>  ? VolumeFamily::box
                                             : VolumeFamily::convex;
    }

    std::span<const std::uint32_t> items(std::uint32_t node) const override {
        const TopologyNode& place = hierarchy_.topology->nodes[node];
        if (!place.is_leaf()) return {};
        return std::span(hierarchy_.topology->order).subspan(place.first, place.count);
    }

  private:
    const V& of(std::uint32_t node) const { return hierarchy_.volumes[node]; }

    const Hierarchy<V>& hierarchy_;
};

}  // namespace

std::string VolumeTree::node_words(std::uint32_t node) const {
    const std::string words = "node " + std::to_string(number(node)), own = name(node);
    return own.empty() ? words : words + " \"" + own + "\"";
}

bool VolumeTree::has_own_numbers() const {
    for (std::uint32_t node = 0; node < size(); ++node)
        if (number(node) != node) return true;
    return false;
}

std::unique_ptr<VolumeTree> volume_tree(const AnyHierarchy& hierarchy) {
    return std::visit(
        []<class V>(const Hierarchy<V>& h) -> std::unique_ptr<VolumeTree> {
            return std::make_unique<OwnTree<V>>(h);
        },
        hierarchy);
}

}  // namespace scb
