#include <CGAL/version.h>

#include <algorithm>

#include "tests/peers/adapters.h"
#include "tests/peers/cgal_tree.h"

namespace scb {
namespace {

class CgalPeer : public Peer {
  public:
    CgalPeer(const PeerMesh& a, const PeerMesh& b, PeerQuery query)
        : b_(b), first_(query == PeerQuery::first_contact) {
        place(a, identity_pose(), triangles_);
        tree_.insert(triangles_.cbegin(), triangles_.cend());
        tree_.build();
    }

    void query(const PeerPose& a, const PeerPose& b) override {
        found_.clear();
        place(b_, relative(a, b), placed_);
        const CGAL::Bbox_3 box = tree_.bbox();
        for (std::size_t j = 0; j < placed_.size(); ++j) {
            const CgalTriangle& triangle = placed_[j];
            if (!CGAL::do_overlap(triangle.bbox(), box)) continue;
            hits_.clear();
            if (!first_)
                tree_.all_intersected_primitives(triangle, std::back_inserter(hits_));
            else if (const auto hit = tree_.any_intersected_primitive(triangle))
                hits_.push_back(*hit);
            for (const CgalTriangles::const_iterator hit : hits_)
                found_.push_back({static_cast<std::uint32_t>(hit - triangles_.cbegin()),
                                  static_cast<std::uint32_t>(j)});
            if (first_ && !found_.empty()) return;
        }
    }

    std::vector<IndexPair> pairs() const override {
        std::vector<IndexPair> pairs = found_;
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

  private:
    const PeerMesh& b_;
    bool first_;
    CgalTriangles triangles_;  // of A
    CgalTree tree_;
    CgalTriangles placed_;
    std::vector<CgalTriangles::const_iterator> hits_;
    std::vector<IndexPair> found_;
};

}  // namespace

PeerKind cgal_peer() {
    PeerKind kind;
    kind.name = "cgal";
    kind.title = "CGAL " CGAL_VERSION_STR ", AABB tree";
    kind.method = "`AABB_tree` of A, asked with every moved triangle of B, exact predicates.";
    kind.prepare = [](const PeerMesh& a, const PeerMesh& b, PeerQuery query) {
        return std::make_unique<CgalPeer>(a, b, query);
    };
    return kind;
}

}  // namespace scb
