#pragma once

#include <algorithm>
#include <cmath>

#include "core/distance/distance_certificate.h"
#include "tests/core/collide/small_scenes.h"
#include "tests/core/geometry/distance_oracle.h"

namespace scb {

/// Two meshes with one tree each.
struct ProofScene {
    Mesh a, b;
    Pose pose;
    Topology of_a, of_b;

    ProofScene(const Mesh& mesh_a, const Mesh& mesh_b, const Pose& b_to_a)
        : a(mesh_a),
          b(mesh_b),
          pose(b_to_a),
          of_a(build_topology(a)),
          of_b(build_topology(b, {.split = SplitMethod::cost})) {}
    MeshTree tree_a() const { return {a, of_a}; }
    MeshTree tree_b() const { return {b, of_b}; }
    TriangleCorners corners_a(std::uint32_t i) const { return corners(a, i); }
    TriangleCorners corners_b(std::uint32_t j) const {
        return transform_corners(pose, corners(b, j));
    }
    ProvenDistance check(const DistanceCertificate& certificate) const {
        return check_distance(tree_a(), tree_b(), pose, certificate);
    }
};

/// The closest triangles, and their distance in higher precision: of all pairs that are about as
/// close as the closest.
struct BruteForce {
    IndexPair closest;
    double rounded = HUGE_VAL;
    long double distance = HUGE_VALL;

    explicit BruteForce(const ProofScene& scene) {
        std::vector<std::pair<double, IndexPair>> all;
        for (std::uint32_t i = 0; i < scene.a.triangles.size(); ++i)
            for (std::uint32_t j = 0; j < scene.b.triangles.size(); ++j)
                all.emplace_back(triangle_distance(scene.corners_a(i), scene.corners_b(j)).distance,
                                 IndexPair{i, j});
        std::sort(all.begin(), all.end());
        rounded = all.front().first;
        closest = all.front().second;
        double largest = 0;
        for (std::uint32_t j = 0; j < scene.b.triangles.size(); ++j)
            for (const Vec3& p : scene.corners_b(j)) largest = std::max(largest, p.norm());
        int measured = 0;
        for (const auto& [found, pair] : all) {
            if (found > rounded * (1 + 1e-9) + 1e-14 * largest || ++measured > 20) break;
            distance = std::min(distance, distance_oracle::distance(scene.corners_a(pair.a),
                                                                    scene.corners_b(pair.b)));
        }
    }
};

/// Whether the bounds hold a distance, up to the rounding of the oracle.
inline bool holds(const ProvenDistance& proven, long double distance) {
    const long double slack =
        1e-18L * static_cast<long double>(proven.largest_coordinate) + 1e-17L * distance;
    return static_cast<long double>(proven.lower) <= distance + slack &&
           static_cast<long double>(proven.upper) >= distance - slack;
}

inline double width_share(const ProvenDistance& proven, double distance) {
    return (proven.upper - proven.lower) / allowed_width(distance, proven.largest_coordinate);
}

}  // namespace scb
