#include <fcl/config.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>

#include "tests/peers/adapters.h"
#include "tests/peers/fcl_model.h"

namespace scb {
namespace {

class FclPeer : public Peer {
  public:
    FclPeer(const PeerMesh& a, const PeerMesh& b, PeerQuery query) {
        build(a, a_);
        build(b, b_);
        // Of contacts FCL keeps the two triangles whether asked for points and normals or not; not
        // asking is what makes it quickest. It ends at this many pairs.
        request_.enable_contact = false;
        request_.num_max_contacts =
            query == PeerQuery::first_contact ? 1 : std::numeric_limits<int>::max();
    }

    void query(const PeerPose& a, const PeerPose& b) override {
        result_.clear();  // keeps its memory
        fcl::collide(&a_, transform(a), &b_, transform(b), request_, result_);
    }

    std::vector<IndexPair> pairs() const override {
        std::vector<IndexPair> pairs;
        for (std::size_t i = 0; i < result_.numContacts(); ++i) {
            const fcl::Contact<double>& contact = result_.getContact(i);
            pairs.push_back(
                {static_cast<std::uint32_t>(contact.b1), static_cast<std::uint32_t>(contact.b2)});
        }
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    double bytes() const override {
        double bytes = 0;
        for (const FclModel* model : {&a_, &b_})
            bytes += model->getNumBVs() * static_cast<double>(sizeof(fcl::BVNode<fcl::OBBd>)) +
                     model->num_tris * static_cast<double>(sizeof(unsigned int));
        return bytes;
    }

  private:
    FclModel a_, b_;
    fcl::CollisionRequest<double> request_;
    fcl::CollisionResult<double> result_;
};

}  // namespace

PeerKind fcl_peer() {
    PeerKind kind;
    kind.name = "fcl";
    kind.title = "FCL " FCL_VERSION ", OBB";
    kind.method =
        "`fcl::collide` of two `BVHModel<OBB<double>>`, without points and "
        "normals.";
    kind.prepare = [](const PeerMesh& a, const PeerMesh& b, PeerQuery query) {
        return std::make_unique<FclPeer>(a, b, query);
    };
    return kind;
}

}  // namespace scb
