#include <cmath>

#include "tests/peers/cgal_tree.h"
#include "tests/peers/point_peer.h"

namespace scb {
namespace {

class CgalPointPeer : public PointPeer {
  public:
    explicit CgalPointPeer(const PeerMesh& mesh) {
        PeerPose identity;
        for (std::size_t i = 0; i < 3; ++i) identity.rotation[i][i] = 1;
        place(mesh, identity, triangles_);
        tree_.insert(triangles_.cbegin(), triangles_.cend());
        tree_.build();
        tree_.accelerate_distance_queries();
    }

    double distance(const std::array<double, 3>& point) override {
        return std::sqrt(tree_.squared_distance(CgalKernel::Point_3(point[0], point[1], point[2])));
    }

  private:
    CgalTriangles triangles_;
    CgalTree tree_;
};

}  // namespace

std::unique_ptr<PointPeer> cgal_point_peer(const PeerMesh& mesh) {
    return std::make_unique<CgalPointPeer>(mesh);
}

}  // namespace scb
