#include "core/packed_hierarchy.h"

#include <cassert>
#include <cmath>

#include "core/collapse.h"
#include "core/error.h"
#include "core/placement.h"

namespace scb {
namespace {

constexpr double largest = 1e8, smallest = 1e-8;
// Kernels load four lanes of a leaf that may have one.
constexpr std::size_t words_behind = 3;

double up(float value) { return static_cast<double>(value); }

void check_range(const Mesh& mesh, std::string_view name) {
    const Box box = bounding_box(mesh);
    const double reach = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
    const double size = (box.upper - box.lower).maxCoeff();
    if (reach <= largest && (size >= smallest || size == 0)) return;
    throw InputError(std::string(name) +
                     ": packed layouts hold coordinates up to 1e8 and sizes from 1e-8 on; scale "
                     "it, or use the reference layout.");
}

template <class Codec>
class Packing {
  public:
    Packing(const Hierarchy<Scb>& hierarchy, const Mesh& mesh)
        : topology_(*hierarchy.topology), volumes_(hierarchy.volumes), mesh_(mesh) {}

    PackedHierarchy<Codec> run(int leaf_triangles) {
        std::vector<double> cost;
        cost.reserve(volumes_.size());
        for (const Scb& scb : volumes_) cost.push_back(surface_area(scb));
        const WideTopology wide = collapse(topology_, cost, Codec::width, leaf_triangles);
        packed_.reach = scb::reach(volumes_[0]);
        packed_.nodes.resize(wide.nodes.size());
        for (std::size_t i = 0; i < wide.nodes.size(); ++i)
            set_node(packed_.nodes[i], wide.nodes[i], wide);
        packed_.root = wide.nodes.empty() ? add_leaf(0) : PackedRef{0};
        packed_.leaves.insert(packed_.leaves.end(), words_behind, 0);
        return std::move(packed_);
    }

  private:
    void set_node(PackedNode<Codec>& node, const WideTopology::Node& from,
                  const WideTopology& wide) {
        node.own = packed(volumes_[from.node], Vec3::Zero());
        node.count = static_cast<std::uint16_t>(from.child_count);
        std::vector<Scb> children;
        for (std::uint32_t k = 0; k < from.child_count; ++k) {
            const WideTopology::Child& child = wide.children[from.first_child + k];
            children.push_back(volumes_[child.node]);
            const bool is_leaf = child.wide == WideTopology::no_node;
            node.child[k] = is_leaf ? add_leaf(child.node).bits : child.wide;
            if (is_leaf) node.leaf_bits = static_cast<std::uint16_t>(node.leaf_bits | 1u << k);
        }
        node.volumes.encode(children, center(node.own));
        double far = up(node.own.r);
        for (std::size_t k = 0; k < children.size(); ++k) {
            const PackedScb scb = node.volumes.decode(k);
            far = std::max(far, std::sqrt(squared_norm(center(scb))) + up(scb.r));
        }
        node.reach = float_above(far * (1 + 0x1p-40));
    }

    PackedRef add_leaf(std::uint32_t i) {
        const TopologyNode& node = topology_.nodes[i];
        const std::size_t at = packed_.leaves.size(), count = node.count;
        packed_.leaves.resize(at + PackedLeaf::size(count));
        std::uint32_t* words = packed_.leaves.data() + at;
        const PackedScb own = packed(volumes_[i], Vec3::Zero());
        std::memcpy(words, &own, sizeof own);
        words[PackedLeaf::header - 1] = node.count;
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint32_t triangle = topology_.order[node.first + k];
            words[PackedLeaf::header + k] = triangle;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Vec3& v = mesh_.vertices[mesh_.triangles[triangle][corner]];
                for (std::size_t axis = 0; axis < 3; ++axis)
                    words[PackedLeaf::header + count * (1 + 3 * corner + axis) + k] =
                        std::bit_cast<std::uint32_t>(
                            static_cast<float>(v[static_cast<int>(axis)] - up(own.c[axis])));
            }
        }
        return {static_cast<std::uint32_t>(at) | PackedRef::leaf_bit};
    }

    const Topology& topology_;
    const std::vector<Scb>& volumes_;
    const Mesh& mesh_;
    PackedHierarchy<Codec> packed_;
};

}  // namespace

template <class Codec>
PackedHierarchy<Codec> pack(const Hierarchy<Scb>& hierarchy, const Mesh& mesh, int leaf_triangles,
                            std::string_view name) {
    assert(leaf_triangles >= 1 && leaf_triangles <= most_leaf_triangles && "see pack");
    check_range(mesh, name);
    return Packing<Codec>(hierarchy, mesh).run(leaf_triangles);
}

#define SCB_PACK(Codec) \
    template PackedHierarchy<Codec> pack(const Hierarchy<Scb>&, const Mesh&, int, std::string_view);
SCB_FOR_EACH_CODEC(SCB_PACK)
#undef SCB_PACK

}  // namespace scb
