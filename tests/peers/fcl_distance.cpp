#include <fcl/config.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/math/bv/RSS.h>
#include <fcl/narrowphase/distance.h>

#include "tests/peers/distance_peer.h"
#include "tests/peers/fcl_model.h"

namespace scb {
namespace {

template <class Volume>
class FclDistancePeer : public DistancePeer {
  public:
    FclDistancePeer(const PeerMesh& a, const PeerMesh& b) {
        build(a, a_);
        build(b, b_);
    }

    void query(const PeerPose& a, const PeerPose& b) override {
        result_.clear();
        distance_ = fcl::distance(&a_, transform(a), &b_, transform(b), request_, result_);
    }
    double distance() const override { return distance_ < 0 ? 0 : distance_; }

  private:
    fcl::BVHModel<Volume> a_, b_;
    // Exact, and without the closest points, which take time.
    fcl::DistanceRequest<double> request_{false, false, 0, 0};
    fcl::DistanceResult<double> result_;
    double distance_ = 0;
};

}  // namespace

std::unique_ptr<DistancePeer> fcl_distance_peer(const PeerMesh& a, const PeerMesh& b,
                                                bool with_obbs) {
    if (with_obbs) return std::make_unique<FclDistancePeer<fcl::OBBRSSd>>(a, b);
    return std::make_unique<FclDistancePeer<fcl::RSSd>>(a, b);
}

std::string fcl_version() { return FCL_VERSION; }

}  // namespace scb
