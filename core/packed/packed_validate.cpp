#include <cmath>
#include <vector>

#include "core/base/text_format.h"
#include "core/packed/each_codec.h"
#include "scb/packed_hierarchy.h"

namespace scb {
namespace {

template <class Codec>
class PackedCheck {
    using Decoded = typename Codec::Decoded;

  public:
    PackedCheck(const PackedHierarchy<Codec>& packed, const Mesh& mesh)
        : packed_(packed), mesh_(mesh), met_(mesh.triangles.size(), 0) {}

    std::string run() {
        check(packed_.root);
        for (std::size_t t = 0; t < met_.size() && failure_.empty(); ++t)
            if (met_[t] == 0) failure_ = sentence("triangle ", t, " is in no leaf.");
        return failure_;
    }

  private:
    void fail(const std::string& failure) {
        if (failure_.empty()) failure_ = failure;
    }

    /// The triangles below.
    std::vector<std::uint32_t> check(PackedRef ref) {
        if (!failure_.empty()) return {};
        return ref.is_leaf() ? check_leaf(ref) : check_node(ref.index());
    }

    std::vector<std::uint32_t> check_node(std::uint32_t index) {
        const PackedNode<Codec>& node = packed_.nodes[index];
        const std::string name = sentence("node ", index);
        if (node.count < 2 || node.count > Codec::width)
            fail(sentence(name, " has ", node.count, " children."));
        std::vector<std::uint32_t> all;
        for (std::size_t k = 0; k < node.count && failure_.empty(); ++k) {
            const PackedRef child{node.child[k]};
            // Not a comparison of two bools, which GCC 12 compiles wrongly here.
            const std::uint32_t is_leaf = child.is_leaf() ? 1 : 0;
            if (is_leaf != (std::uint32_t{node.leaf_bits} >> k & 1))
                fail(sentence(name, " is wrong on whether child ", k, " is a leaf."));
            const std::vector<std::uint32_t> below = check(child);
            const Decoded volume = node.volumes.decode(k);
            check_inside(volume, center(node.own), below, sentence("child ", k, " of ", name));
            if (std::sqrt(squared_norm(center(volume))) + static_cast<double>(volume.r) >
                static_cast<double>(node.reach))
                fail(sentence("child ", k, " of ", name, " reaches farther than the node says."));
            all.insert(all.end(), below.begin(), below.end());
        }
        check_inside(node.own, Vec3::Zero(), all, name);
        return all;
    }

    std::vector<std::uint32_t> check_leaf(PackedRef ref) {
        const PackedLeaf leaf = packed_.leaf(ref);
        const std::string name = sentence("the leaf at word ", ref.index());
        if (leaf.count() < 1 || leaf.count() > most_leaf_triangles) {
            fail(sentence(name, " has ", leaf.count(), " triangles."));
            return {};
        }
        std::vector<std::uint32_t> all;
        for (std::size_t k = 0; k < leaf.count(); ++k) all.push_back(leaf.triangle(k));
        for (std::size_t k = 0; k < all.size() && failure_.empty(); ++k) {
            if (all[k] >= met_.size() || ++met_[all[k]] > 1) {
                fail(sentence("triangle ", all[k], " is not in exactly one leaf."));
                return {};
            }
            if (packed_.corners == LeafCorners::stored) check_corners(leaf, k);
        }
        check_inside(leaf.template own<Decoded>(), Vec3::Zero(), all, name);
        return all;
    }

    void check_corners(const PackedLeaf& leaf, std::size_t k) {
        const Vec3 origin = center(leaf.template own<Decoded>());
        const std::uint32_t triangle = leaf.triangle(k);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vec3 p = mesh_.vertices[mesh_.triangles[triangle][corner]] - origin;
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (leaf.corners()[(3 * corner + axis) * leaf.count() + k] !=
                    static_cast<float>(p[static_cast<int>(axis)]))
                    fail(sentence("corner ", corner, " of triangle ", triangle,
                                  " is not the nearest float."));
        }
    }

    void check_inside(const Decoded& volume, const Vec3& origin,
                      const std::vector<std::uint32_t>& triangles, const std::string& name) {
        for (const std::uint32_t t : triangles)
            for (const std::uint32_t v : mesh_.triangles[t])
                if (!contains(volume, mesh_.vertices[v] - origin))
                    fail(sentence("vertex ", v, " of triangle ", t, " is outside the volume of ",
                                  name, "."));
    }

    const PackedHierarchy<Codec>& packed_;
    const Mesh& mesh_;
    std::vector<std::uint8_t> met_;
    std::string failure_;
};

}  // namespace

template <class Codec>
std::string validate(const PackedHierarchy<Codec>& packed, const Mesh& mesh) {
    return PackedCheck<Codec>(packed, mesh).run();
}

#define SCB_VALIDATE(...) \
    template std::string validate(const PackedHierarchy<__VA_ARGS__>&, const Mesh&);
SCB_FOR_EACH_CODEC(SCB_VALIDATE)
#undef SCB_VALIDATE

}  // namespace scb
