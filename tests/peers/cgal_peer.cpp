#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include <algorithm>

#include "tests/peers/adapters.h"

namespace scb {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Triangles = std::vector<Triangle>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

/// `inverse(a) * b`.
PeerPose relative(const PeerPose& a, const PeerPose& b) {
    PeerPose result;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                result.rotation[i][j] += a.rotation[k][i] * b.rotation[k][j];
        for (std::size_t k = 0; k < 3; ++k)
            result.translation[i] += a.rotation[k][i] * (b.translation[k] - a.translation[k]);
    }
    return result;
}

Point place(const PeerPose& pose, const std::array<double, 3>& v) {
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& r = pose.rotation[i];
        x[i] = r[0] * v[0] + r[1] * v[1] + r[2] * v[2] + pose.translation[i];
    }
    return {x[0], x[1], x[2]};
}

class CgalPeer : public Peer {
  public:
    CgalPeer(const PeerMesh& a, const PeerMesh& b) : b_(b) {
        std::vector<Point> points;
        for (const auto& v : a.vertices) points.emplace_back(v[0], v[1], v[2]);
        for (const auto& t : a.triangles)
            triangles_.emplace_back(points[t[0]], points[t[1]], points[t[2]]);
        tree_.insert(triangles_.cbegin(), triangles_.cend());
        tree_.build();
    }

    void query(const PeerPose& a, const PeerPose& b) override {
        found_.clear();
        const PeerPose b_to_a = relative(a, b);
        placed_.clear();
        for (const auto& v : b_.vertices) placed_.push_back(place(b_to_a, v));
        const CGAL::Bbox_3 box = tree_.bbox();
        for (std::size_t j = 0; j < b_.triangles.size(); ++j) {
            const auto& t = b_.triangles[j];
            const Triangle triangle(placed_[t[0]], placed_[t[1]], placed_[t[2]]);
            if (!CGAL::do_overlap(triangle.bbox(), box)) continue;
            hits_.clear();
            tree_.all_intersected_primitives(triangle, std::back_inserter(hits_));
            for (const Triangles::const_iterator hit : hits_)
                found_.push_back({static_cast<std::uint32_t>(hit - triangles_.cbegin()),
                                  static_cast<std::uint32_t>(j)});
        }
    }

    std::vector<IndexPair> pairs() const override {
        std::vector<IndexPair> pairs = found_;
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

  private:
    const PeerMesh& b_;
    Triangles triangles_;  // of A
    Tree tree_;
    std::vector<Point> placed_;
    std::vector<Triangles::const_iterator> hits_;
    std::vector<IndexPair> found_;
};

}  // namespace

PeerKind cgal_peer() {
    PeerKind kind;
    kind.name = "cgal";
    kind.title = "CGAL " CGAL_VERSION_STR ", AABB tree";
    kind.method = "`AABB_tree` of A, asked with every moved triangle of B, exact predicates.";
    kind.prepare = [](const PeerMesh& a, const PeerMesh& b) {
        return std::make_unique<CgalPeer>(a, b);
    };
    return kind;
}

}  // namespace scb
