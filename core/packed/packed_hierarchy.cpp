#include "scb/packed_hierarchy.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/large_pages.h"
#include "core/base/parallel_for.h"
#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "core/packed/collapse.h"
#include "core/packed/each_codec.h"
#include "core/packed/grown_slab.h"
#include "core/packed/visit_costs.h"
#include "scb/error.h"
#include "scb/placement.h"

namespace scb {
namespace {

constexpr double largest = 1e8, smallest = 1e-8;
// Kernels load four lanes of a leaf that may have one triangle, and prefetch some lines.
constexpr std::size_t words_behind = PackedLeaf::fetched_words;

double up(float value) { return static_cast<double>(value); }

/// The volumes of the nodes of a topology, or of those that are packed.
template <class V>
struct NodeVolumes {
    const std::vector<V>& volumes;
    std::span<const std::uint32_t> place = {};  ///< see fit_some; empty: volumes of all nodes

    const V& operator[](std::uint32_t node) const {
        return volumes[place.empty() ? node : place[node]];
    }
};

template <class Codec>
class Packing {
    using Volume = typename Codec::Volume;
    using Decoded = typename Codec::Decoded;

  public:
    Packing(const Topology& topology, const NodeVolumes<Volume>& volumes, const Mesh& mesh,
            LeafCorners corners, std::string_view name, int threads)
        : topology_(topology), volumes_(volumes), mesh_(mesh), name_(name), threads_(threads) {
        packed_.corners = corners;
    }

    PackedHierarchy<Codec> run(const WideTopology& wide) {
        packed_.reach = scb::reach(volumes_[0]);
        resize_large(packed_.nodes, wide.nodes.size());
        place_leaves(wide);
        parallel_blocks(threads_, wide.nodes.size(), [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i)
                set_node(packed_.nodes[i], wide.nodes[i], wide);
        });
        if (wide.nodes.empty()) packed_.root = set_leaf(0, 0);
        return std::move(packed_);
    }

  private:
    // Finds the begin of each node's first leaf; the leaves of a node follow each other.
    void place_leaves(const WideTopology& wide) {
        std::size_t words = wide.nodes.empty() ? leaf_size(0) : 0;
        double radii = wide.nodes.empty() ? volumes_[0].r : 0;
        std::size_t leaves = wide.nodes.empty() ? 1 : 0;
        first_leaf_.reserve(wide.nodes.size());
        for (const WideTopology::Node& node : wide.nodes) {
            first_leaf_.push_back(words);
            for (std::uint32_t k = 0; k < node.child_count; ++k) {
                const WideTopology::Child& child = wide.children[node.first_child + k];
                if (child.wide != WideTopology::no_node) continue;
                words += leaf_size(child.node);
                radii += volumes_[child.node].r;
                ++leaves;
            }
        }
        if (words >= PackedRef::leaf_bit)
            throw InputError(name_ +
                             ": too many triangles for this packed layout; give larger leaves, an "
                             "indexed layout, or the reference.");
        resize_large(packed_.leaves, words + words_behind);
        packed_.leaf_radius = radii / static_cast<double>(leaves);
    }
    std::size_t leaf_size(std::uint32_t i) const {
        return PackedLeaf::words_before<Decoded> +
               PackedLeaf::size(topology_.nodes[i].count, packed_.corners);
    }

    void set_node(PackedNode<Codec>& node, const WideTopology::Node& from,
                  const WideTopology& wide) {
        node.own = packed(volumes_[from.node], Vec3::Zero());
        node.count = static_cast<std::uint16_t>(from.child_count);
        std::array<Volume, Codec::width> children;
        std::size_t leaf = first_leaf_[static_cast<std::size_t>(&node - packed_.nodes.data())];
        for (std::uint32_t k = 0; k < from.child_count; ++k) {
            const WideTopology::Child& child = wide.children[from.first_child + k];
            children[k] = volumes_[child.node];
            if (child.wide != WideTopology::no_node) {
                node.child[k] = child.wide;
                continue;
            }
            node.child[k] = set_leaf(child.node, leaf).bits;
            node.leaf_bits = static_cast<std::uint16_t>(node.leaf_bits | 1u << k);
            leaf += leaf_size(child.node);
        }
        node.volumes.encode({children.data(), from.child_count}, center(node.own));
        double far = up(node.own.r);
        for (std::size_t k = 0; k < from.child_count; ++k) {
            const Decoded volume = node.volumes.decode(k);
            far = std::max(far, std::sqrt(squared_norm(center(volume))) + up(volume.r));
        }
        node.reach = float_above(far * (1 + 0x1p-40));
    }

    PackedRef set_leaf(std::uint32_t i, std::size_t at) {
        const TopologyNode& node = topology_.nodes[i];
        at += PackedLeaf::words_before<Decoded>;
        float* words = packed_.leaves.data() + at;
        PackedLeaf::write_volume(words, packed(volumes_[i], Vec3::Zero()));
        words[PackedLeaf::ball] = std::bit_cast<float>(node.count);
        for (std::uint32_t k = 0; k < node.count; ++k)
            words[PackedLeaf::header + k] = std::bit_cast<float>(topology_.order[node.first + k]);
        if (packed_.corners == LeafCorners::stored) PackedLeaf::write_corners(words, mesh_);
        return {static_cast<std::uint32_t>(at) | PackedRef::leaf_bit};
    }

    const Topology& topology_;
    const NodeVolumes<Volume> volumes_;
    const Mesh& mesh_;
    std::string name_;
    int threads_;
    std::vector<std::size_t> first_leaf_;
    PackedHierarchy<Codec> packed_;
};

}  // namespace

void check_packable(const Mesh& mesh, std::string_view name) {
    const Box box = bounding_box(mesh);
    const double reach = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
    const double size = (box.upper - box.lower).maxCoeff();
    if (reach <= largest && (size >= smallest || size == 0)) return;
    throw InputError(std::string(name) +
                     ": packed layouts hold coordinates up to 1e8 and sizes from 1e-8 on; scale "
                     "it, or use the reference layout.");
}

void PackedLeaf::write_corners(float* words, const Mesh& mesh) {
    const PackedLeaf leaf{words};
    const std::size_t count = leaf.count();
    const float* const origin = leaf.center();
    for (std::size_t k = 0; k < count; ++k) {
        const Triangle& triangle = mesh.triangles[leaf.triangle(k)];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vec3& v = mesh.vertices[triangle[corner]];
            for (std::size_t axis = 0; axis < 3; ++axis)
                words[header + count * (1 + 3 * corner + axis) + k] =
                    static_cast<float>(v[static_cast<int>(axis)] - up(origin[axis]));
        }
    }
}

template <class Codec>
PackedHierarchy<Codec> pack(const Hierarchy<typename Codec::Volume>& hierarchy, const Mesh& mesh,
                            int leaf_triangles, LeafCorners corners, std::string_view name,
                            int threads) {
    assert(leaf_triangles >= 1 && leaf_triangles <= most_leaf_triangles && "see pack");
    check_packable(mesh, name);
    const Topology& topology = *hierarchy.topology;
    const WideTopology wide = collapse(topology, visit_costs(mesh, topology, threads), Codec::width,
                                       leaf_triangles, threads);
    return Packing<Codec>(topology, {hierarchy.volumes}, mesh, corners, name, threads).run(wide);
}

template <class Codec>
PackedHierarchy<Codec> build_packed(const Mesh& mesh, const BuildOptions& options,
                                    int leaf_triangles, LeafCorners corners,
                                    std::string_view name) {
    assert(leaf_triangles >= 1 && leaf_triangles <= most_leaf_triangles && "see build_packed");
    MeshTopology shared = checked_topology(mesh, options, name);
    check_packable(mesh, name);
    const Topology& topology = *shared.topology;
    const WideTopology wide = collapse(topology, visit_costs(mesh, topology, options.threads),
                                       Codec::width, leaf_triangles, options.threads);
    std::vector<std::uint32_t> place(topology.nodes.size(), no_place);
    std::uint32_t count = 0;
    place[0] = count++;
    for (const WideTopology::Child& child : wide.children) place[child.node] = count++;
    const auto volumes = fit_some<typename Codec::Volume>(topology, shared.points, options.fit,
                                                          options.threads, place, count);
    // What is not needed any more is freed before the packed nodes are made.
    shared.points = {};
    return Packing<Codec>(topology, {volumes, place}, mesh, corners, name, options.threads)
        .run(wide);
}

#define SCB_PACK(...)                                                                              \
    template PackedHierarchy<__VA_ARGS__> pack<__VA_ARGS__>(const Hierarchy<__VA_ARGS__::Volume>&, \
                                                            const Mesh&, int, LeafCorners,         \
                                                            std::string_view, int);                \
    template PackedHierarchy<__VA_ARGS__> build_packed<__VA_ARGS__>(                               \
        const Mesh&, const BuildOptions&, int, LeafCorners, std::string_view);
SCB_FOR_EACH_CODEC(SCB_PACK)
#undef SCB_PACK

}  // namespace scb
