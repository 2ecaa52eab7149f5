#pragma once

#include <algorithm>
#include <vector>

#include "scb/collide.h"
#include "scb/triangle_overlap.h"

namespace scb {

/// Every pair of triangles that intersects, by testing all of them whose boxes meet: the boxes are
/// of the same corners, so this leaves nothing out.
inline std::vector<IndexPair> brute_force(const Mesh& a, const Mesh& b, const Pose& b_to_a) {
    const auto box_of = [](const TriangleCorners& t) {
        Box box;
        for (const Vec3& p : t) box.add(p);
        return box;
    };
    std::vector<TriangleCorners> corners_b;
    std::vector<Box> boxes_b;
    for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
        corners_b.push_back(transform_corners(b_to_a, corners(b, j)));
        boxes_b.push_back(box_of(corners_b.back()));
    }
    std::vector<IndexPair> pairs;
    for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
        const TriangleCorners t = corners(a, i);
        const Box box = box_of(t);
        for (std::uint32_t j = 0; j < corners_b.size(); ++j) {
            const Box& other = boxes_b[j];
            if (box.lower[0] > other.upper[0] || other.lower[0] > box.upper[0] ||
                box.lower[1] > other.upper[1] || other.lower[1] > box.upper[1] ||
                box.lower[2] > other.upper[2] || other.lower[2] > box.upper[2])
                continue;
            if (triangles_overlap(t, corners_b[j])) pairs.push_back({i, j});
        }
    }
    return pairs;
}

/// Whether the triangle's corners are collinear, up to rounding: of the triangles that tests tell
/// apart by this, none is near the bound.
inline bool is_degenerate(const Mesh& mesh, std::uint32_t triangle) {
    const TriangleCorners t = corners(mesh, triangle);
    const Vec3 u = t[1] - t[0], v = t[2] - t[0], w = t[2] - t[1];
    const double longest = std::max({squared_norm(u), squared_norm(v), squared_norm(w)});
    return squared_norm(cross(u, v)) <= 1e-28 * longest * longest;
}

}  // namespace scb
