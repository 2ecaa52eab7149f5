#include "tests/peers/scb_distance.h"

#include <map>

#include "tests/peers/core_mesh.h"

namespace scb {
namespace {

class OwnDistancePeer : public DistancePeer {
  public:
    OwnDistancePeer(const DistanceBodies& bodies, DistanceTree tree, DistanceOrder order,
                    bool seeded)
        : bodies_(bodies), tree_(tree), seeded_(seeded) {
        options_.order = order;
    }

    void query(const PeerPose& a, const PeerPose& b) override {
        const auto& [of_a, of_b] = bodies_;
        const Pose b_to_a = relative_pose(core_pose(a), core_pose(b));
        if (seeded_) options_.seed = seeds_[b.translation];
        std::optional<IndexPair> closest;
        switch (tree_) {
            case DistanceTree::reference: {
                const Distance found = scb::distance<Scb2>(
                    {of_a.reference, of_a.mesh}, {of_b.reference, of_b.mesh}, b_to_a, options_);
                take(found);
                closest = found.triangles;
                break;
            }
            case DistanceTree::packed:
                closest = packed(PackedCollider{of_a.packed, of_a.mesh},
                                 PackedCollider{of_b.packed, of_b.mesh}, b_to_a);
                break;
            case DistanceTree::packed_one_slab:
                closest = packed(PackedCollider{of_a.one_slab, of_a.mesh},
                                 PackedCollider{of_b.one_slab, of_b.mesh}, b_to_a);
                break;
        }
        if (seeded_) seeds_[b.translation] = closest;
    }
    double distance() const override { return distance_; }
    std::uint64_t n_v() const override { return n_v_; }
    std::uint64_t n_p() const override { return n_p_; }

  private:
    template <class Found>
    void take(const Found& found) {
        distance_ = found.found.distance;
        n_v_ = found.n_v;
        n_p_ = found.n_p;
    }
    template <class Codec>
    std::optional<IndexPair> packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                                    const Pose& b_to_a) {
        const PackedDistance found = distance_packed(a, b, b_to_a, options_);
        take(found);
        return found.triangles;
    }

    const DistanceBodies& bodies_;
    DistanceTree tree_;
    bool seeded_;
    DistanceOptions options_;
    std::map<std::array<double, 3>, std::optional<IndexPair>> seeds_;
    double distance_ = 0;
    std::uint64_t n_v_ = 0, n_p_ = 0;
};

}  // namespace

DistanceBodies::Body::Body(const Mesh& from)
    : mesh(from),
      reference(build_hierarchy<Scb2>(mesh, packed_build)),
      packed(build_packed(mesh)),
      one_slab(build_packed<QuantizedCodec<8, Scb>>(mesh)) {}

DistanceBodies::DistanceBodies(const Mesh& of_a, const Mesh& of_b) : a(of_a), b(of_b) {}

std::unique_ptr<DistancePeer> own_distance_peer(const DistanceBodies& bodies, DistanceTree tree,
                                                DistanceOrder order, bool seeded) {
    return std::make_unique<OwnDistancePeer>(bodies, tree, order, seeded);
}

}  // namespace scb
