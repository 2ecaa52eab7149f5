#include "core/distance/distance_certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/distance/hull_separation.h"
#include "core/distance/precise_features.h"

namespace scb {
namespace {

SurfacePoint surface_point(std::uint32_t triangle, const std::array<double, 3>& weights) {
    const auto largest = static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) -
                                                  weights.begin());
    const auto share = [&](std::size_t step) {
        return std::clamp(weights[(largest + step) % 3], 0.0, 0.5);
    };
    return {triangle, static_cast<std::uint32_t>(largest), share(1), share(2)};
}

/// Per node half of the diagonal of the box of its corners.
std::vector<double> node_sizes(const Topology& topology, const PlacedCorners& leaves) {
    std::vector<Box> boxes(topology.nodes.size());
    std::vector<double> sizes(boxes.size());
    // Children come after their parents.
    for (std::size_t i = boxes.size(); i-- > 0;) {
        const TopologyNode& node = topology.nodes[i];
        if (node.is_leaf()) {
            for (const Vec3& p : leaves.below(node)) boxes[i].add(p);
        } else {
            boxes[i] = boxes[node.left];
            boxes[i].add(boxes[node.left + 1]);
        }
        sizes[i] = (boxes[i].upper - boxes[i].lower).norm() / 2;
    }
    return sizes;
}

/// Divides pairs of nodes until each is apart along a direction.
class CutSearch {
  public:
    CutSearch(const MeshTree& a, const MeshTree& b, const PlacedCorners& of_a,
              const PlacedCorners& of_b, double enough)
        : a_(a),
          b_(b),
          of_a_(of_a),
          of_b_(of_b),
          sizes_a_(node_sizes(a.topology, of_a)),
          sizes_b_(node_sizes(b.topology, of_b)),
          magnitude_(3 * (of_a.largest_coordinate + of_b.largest_coordinate)),
          enough_(enough) {}

    void write(DistanceCertificate& certificate) {
        // The direction of the parent is a good one to begin with.
        std::vector<Pair> pending = {{0, 0, Vec3::UnitX()}};
        while (!pending.empty()) {
            const Pair pair = pending.back();
            pending.pop_back();
            const TopologyNode &a = a_.topology.nodes[pair.a], &b = b_.topology.nodes[pair.b];
            const auto corners_a = of_a_.below(a), corners_b = of_b_.below(b);
            const HullSeparation hulls =
                separate_hulls(corners_a, corners_b, pair.direction, enough_);
            const bool is_proven =
                hulls.verdict == HullVerdict::apart &&
                proven_gap(corners_a, corners_b, hulls.direction, magnitude_, enough_) >= enough_;
            if (is_proven || (a.is_leaf() && b.is_leaf())) {
                certificate.cut.push_back(CutStep::end);
                certificate.directions.push_back(
                    is_proven ? hulls.direction
                              : best_direction(corners_a, corners_b, hulls.direction));
            } else if (b.is_leaf() || (!a.is_leaf() && sizes_a_[pair.a] >= sizes_b_[pair.b])) {
                certificate.cut.push_back(CutStep::divide_a);
                for (const std::uint32_t child : {a.left + 1, a.left})
                    pending.push_back({child, pair.b, hulls.direction});
            } else {
                certificate.cut.push_back(CutStep::divide_b);
                for (const std::uint32_t child : {b.left + 1, b.left})
                    pending.push_back({pair.a, child, hulls.direction});
            }
        }
    }

  private:
    using Points = std::span<const Vec3>;
    struct Pair {
        std::uint32_t a, b;
        Vec3 direction;
    };

    /// For two triangles. What they cannot prove, no other pair needs to prove.
    Vec3 best_direction(Points a, Points b, const Vec3& rough) {
        const auto gap = [&](const Vec3& n) { return proven_gap(a, b, n, magnitude_, enough_); };
        Vec3 best = rough;
        double widest = gap(best);
        // Not only the closest: the normal of a needle is inexact, its edges do as well.
        for (const PreciseFeatures& features :
             precise_features({a[0], a[1], a[2]}, {b[0], b[1], b[2]})) {
            if (widest >= enough_) break;
            if (!(gap(features.direction) > widest)) continue;
            best = features.direction;
            widest = gap(best);
        }
        enough_ = std::min(enough_, widest);
        return best;
    }

    const MeshTree &a_, &b_;
    const PlacedCorners &of_a_, &of_b_;
    std::vector<double> sizes_a_, sizes_b_;
    double magnitude_, enough_;
};

}  // namespace

DistanceCertificate make_certificate(const MeshTree& a, const MeshTree& b, const Pose& b_to_a,
                                     const IndexPair& closest) {
    DistanceCertificate certificate;
    const TriangleCorners of_a = corners(a.mesh, closest.a),
                          of_b = transform_corners(b_to_a, corners(b.mesh, closest.b));
    const PreciseFeatures features = precise_features(of_a, of_b).front();
    certificate.on_a = surface_point(closest.a, features.weights_a);
    certificate.on_b = surface_point(closest.b, features.weights_b);
    // Without a cut, this checks the points, or that the triangles intersect.
    const ProvenDistance proven = check_distance(a, b, b_to_a, certificate);
    const double enough = proven.upper - allowed_width(proven.upper, proven.largest_coordinate) / 4;
    if (!(enough > 0)) return certificate;
    const PlacedCorners leaves_a = placed_corners(a, nullptr),
                        leaves_b = placed_corners(b, &b_to_a);
    CutSearch(a, b, leaves_a, leaves_b, enough).write(certificate);
    return certificate;
}

double allowed_width(double distance, double largest_coordinate) {
    return 1e-9 * distance + 4 * 0x1p-52 * largest_coordinate;
}

double distance_rounding(const MeshTree& a, const MeshTree& b, const Pose& b_to_a) {
    return allowed_width(0, std::max(placed_corners(a, nullptr).largest_coordinate,
                                     placed_corners(b, &b_to_a).largest_coordinate));
}

bool certifies(const ProvenDistance& proven, double distance) {
    const double error = allowed_width(0, proven.largest_coordinate);
    return proven.fault.empty() && (distance == 0) == (proven.upper == 0) &&
           proven.upper - proven.lower <= allowed_width(distance, proven.largest_coordinate) &&
           distance >= proven.lower - error && distance <= proven.upper + error;
}

}  // namespace scb
