#include <algorithm>

#include "tests/peers/adapters.h"
#include "tests/peers/bullet_body.h"

namespace scb {
namespace {

class BulletPeer : public Peer {
  public:
    BulletPeer(const PeerMesh& a, const PeerMesh& b, PeerQuery query)
        : a_(a), b_(b), first_(query == PeerQuery::first_contact) {}

    /// The steps of GImpact's collision algorithm, without the manifold: pairs of boxes, then its
    /// test of two triangles, whose result is contacts.
    void query(const PeerPose& a, const PeerPose& b) override {
        const btTransform at_a = transform(a), at_b = transform(b);
        candidates_.resizeNoInitialize(0);  // keeps its memory
        found_.clear();
        btGImpactBoxSet::find_collision(&a_.boxes(), at_a, &b_.boxes(), at_b, candidates_);
        for (int i = 0; i < candidates_.size(); ++i)
            if (triangles_collide(a_, at_a, b_, at_b, candidates_[i])) {
                found_.push_back({static_cast<std::uint32_t>(candidates_[i].m_index1),
                                  static_cast<std::uint32_t>(candidates_[i].m_index2)});
                if (first_) return;
            }
    }

    std::vector<IndexPair> pairs() const override {
        std::vector<IndexPair> pairs = found_;
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    double bytes() const override {
        return static_cast<double>(sizeof(BT_QUANTIZED_BVH_NODE)) *
               (a_.boxes().getNodeCount() + b_.boxes().getNodeCount());
    }

  private:
    BulletBody a_, b_;
    bool first_;
    btPairSet candidates_;
    std::vector<IndexPair> found_;
};

}  // namespace

PeerKind bullet_peer() {
    PeerKind kind;
    kind.name = "bullet";
    const int version = btGetVersion();
    kind.title = "Bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100) +
                 ", GImpact";
    kind.method =
        "`btGImpactBoxSet::find_collision`, then GImpact's test of two triangles, in "
        "floats and without a margin; that test finds contacts, so it takes some pairs "
        "that only pass near each other for pairs that meet.";
    kind.prepare = [](const PeerMesh& a, const PeerMesh& b, PeerQuery query) {
        return std::make_unique<BulletPeer>(a, b, query);
    };
    return kind;
}

}  // namespace scb
