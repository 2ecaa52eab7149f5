#include "core/judge/self_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/geometry/triangle_pair.h"
#include "core/hierarchy/mesh_topology.h"
#include "scb/triangle_distance.h"
#include "scb/triangle_overlap.h"

namespace scb {
namespace {

/// The distance of an edge from a triangle; 0 if they meet.
double edge_gap(const Vec3& from, const Vec3& to, const TriangleCorners& triangle) {
    const TriangleCorners edge{from, to, to};
    return triangle_distance(edge, triangle).distance;
}

/// For two triangles with a common edge from corner 0 to corner 1: whether the free corners lie on
/// one side of it, and one is within `tolerance` of the other triangle's plane.
bool fold_together(const TriangleCorners& a, const TriangleCorners& b, double tolerance) {
    const Vec3 edge = a[1] - a[0], to_a = a[2] - a[0], to_b = b[2] - b[0];
    const double square = squared_norm(edge);
    if (!(square > 0)) return true;
    const Vec3 up_a = to_a - edge * (dot(edge, to_a) / square),
               up_b = to_b - edge * (dot(edge, to_b) / square);
    if (dot(up_a, up_b) < 0) {
        // They lean away from each other, unless one is flat within the tolerance.
        return std::sqrt(squared_norm(up_a)) <= tolerance ||
               std::sqrt(squared_norm(up_b)) <= tolerance;
    }
    const auto off_plane = [](const Vec3& up, const Vec3& other) {
        const double across = squared_norm(other);
        if (!(across > 0)) return std::sqrt(squared_norm(up));
        return std::sqrt(squared_norm(Vec3(up - other * (dot(up, other) / across))));
    };
    return std::min(off_plane(up_a, up_b), off_plane(up_b, up_a)) <= tolerance;
}

}  // namespace

SelfPairs::SelfPairs(const Mesh& mesh, const Mesh& rest)
    : mesh_(mesh), joined_(joined_vertices(rest)) {}

bool SelfPairs::may_share_vertex(std::uint32_t i, std::uint32_t j, double distance) const {
    for (const std::uint32_t a : mesh_.triangles[i])
        for (const std::uint32_t b : mesh_.triangles[j])
            if (joined_[a] != joined_[b] &&
                squared_norm(Vec3(mesh_.vertices[a] - mesh_.vertices[b])) <= distance * distance)
                return true;
    return false;
}

std::size_t SelfPairs::arrange(std::uint32_t i, std::uint32_t j, TriangleCorners& of_i,
                               TriangleCorners& of_j) const {
    of_i = corners(mesh_, i);
    of_j = corners(mesh_, j);
    Triangle a = mesh_.triangles[i], b = mesh_.triangles[j];
    std::size_t shared = 0;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t m = shared; m < 3; ++m) {
            if (joined_[a[k]] != joined_[b[m]]) continue;
            std::swap(a[shared], a[k]);
            std::swap(of_i[shared], of_i[k]);
            std::swap(b[shared], b[m]);
            std::swap(of_j[shared], of_j[m]);
            ++shared;
            break;
        }
    return shared;
}

bool SelfPairs::share_vertex(std::uint32_t i, std::uint32_t j) const {
    return scb::share_vertex(mesh_, joined_, i, j);
}

bool SelfPairs::may_meet_elsewhere(std::uint32_t i, std::uint32_t j, double tolerance) const {
    TriangleCorners a, b;
    switch (arrange(i, j, a, b)) {
        case 0:
            return triangle_distance(a, b).distance <= tolerance;
        case 1:
            return std::min(edge_gap(a[1], a[2], b), edge_gap(b[1], b[2], a)) <= tolerance;
        case 2:
            return fold_together(a, b, tolerance);
        default:
            return true;
    }
}

std::vector<IndexPair> SelfPairs::all(const Hierarchy<Obb>& hierarchy) const {
    return collide_self(SelfCollider<Obb>{hierarchy, mesh_, joined_}).pairs;
}

}  // namespace scb
