#include "scenes/meshes/volume_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/portable_math.h"
#include "core/volumes/convex_shape.h"

namespace scb::scenes {
namespace {

// Two unit vectors that make a right-handed frame with n.
std::pair<Vec3, Vec3> frame_about(const Vec3& n) {
    const int smallest = std::abs(n[0]) <= std::abs(n[1]) && std::abs(n[0]) <= std::abs(n[2]) ? 0
                         : std::abs(n[1]) <= std::abs(n[2])                                   ? 1
                                                                                              : 2;
    const Vec3 side = cross(n, Vec3(Vec3::Unit(smallest)));
    const Vec3 u = side / std::sqrt(squared_norm(side));
    return {u, cross(n, u)};
}

std::uint32_t next_index(const Mesh& mesh) {
    return static_cast<std::uint32_t>(mesh.vertices.size());
}

/// Lengths up to this cannot be distinguished from 0 in coordinates of this size.
double resolution(const Vec3& center, double size) {
    return 1e-12 * (center.cwiseAbs().maxCoeff() + size);
}

}  // namespace

Mesh volume_mesh(const Scb& s, int segments) {
    Mesh mesh;
    const double least = resolution(s.c, s.r);
    if (!(s.r > least) || s.f > s.r || s.e < -s.r) return mesh;
    const double top = std::min(s.e, s.r), bottom = std::max(s.f, -s.r);
    const std::pair<Vec3, Vec3> axes = frame_about(s.n);
    const Vec3 &u = axes.first, &v = axes.second;
    const auto corners = static_cast<std::uint32_t>(segments);

    // Circles of latitude from the bottom to the top. A cut through a pole has no circle, and the
    // fan of its middle extends to the next circle.
    const double pole = std::max(1e-6 * s.r, least);
    const auto radius_at = [&](double height) {
        return std::sqrt(std::max(0.0, s.r * s.r - height * height));
    };
    std::vector<double> heights;
    if (radius_at(bottom) > pole) heights.push_back(bottom);
    const int belts = std::max(2, segments / 2);
    for (int i = 1; i < belts; ++i) {
        const double height = -s.r * sin_cos_turns(0.5 * i / belts).cos;
        if (bottom + pole < height && height + pole < top) heights.push_back(height);
    }
    const bool is_disc = !heights.empty() && top - heights.back() <= least;
    if (radius_at(top) > pole && !is_disc) heights.push_back(top);
    if (heights.empty()) return mesh;

    const std::uint32_t first_ring = next_index(mesh);
    for (const double height : heights) {
        for (int k = 0; k < segments; ++k) {
            const SinCos at = sin_cos_turns(static_cast<double>(k) / segments);
            mesh.vertices.push_back(s.c + height * s.n +
                                    radius_at(height) * (at.cos * u + at.sin * v));
        }
    }
    const auto fan = [&](double height, std::uint32_t rim, bool up) {
        const std::uint32_t middle = next_index(mesh);
        mesh.vertices.push_back(s.c + height * s.n);
        for (std::uint32_t k = 0; k < corners; ++k) {
            const std::uint32_t a = rim + k, b = rim + (k + 1) % corners;
            mesh.triangles.push_back(up ? Triangle{middle, a, b} : Triangle{middle, b, a});
        }
    };
    fan(bottom, first_ring, false);
    std::uint32_t below = first_ring;
    for (std::size_t i = 1; i < heights.size(); ++i) {
        const std::uint32_t above = below + corners;
        for (std::uint32_t k = 0; k < corners; ++k) {
            const std::uint32_t next = (k + 1) % corners;
            mesh.triangles.push_back({below + k, below + next, above + next});
            mesh.triangles.push_back({below + k, above + next, above + k});
        }
        below = above;
    }
    fan(top, below, true);
    return mesh;
}

namespace {

/// The part inside the slabs of the disc in which a plane across the long axis cuts the ball: a
/// region that contains the axis, in coordinates along the two normals.
struct Slice {
    double radius;
    std::array<double, 2> lower, upper;

    Slice(const Scb2& s, double height)
        : radius(std::sqrt(std::max(0.0, (s.r - height) * (s.r + height)))) {
        for (std::size_t i = 0; i < 2; ++i) {
            lower[i] = std::max(s.slabs[i].f, -radius);
            upper[i] = std::min(s.slabs[i].e, radius);
        }
    }

    /// `count` points of its border, about the middle of the rectangle: a quarter of them from each
    /// of the rectangle's corners on, so that the corners are among them.
    std::vector<std::array<double, 2>> border(int count) const {
        const std::array<double, 2> middle = {(lower[0] + upper[0]) / 2, (lower[1] + upper[1]) / 2},
                                    half = {(upper[0] - lower[0]) / 2, (upper[1] - lower[1]) / 2};
        std::vector<std::array<double, 2>> points;
        for (int k = 0; k < count; ++k) {
            // Along the sides of the rectangle, counterclockwise from its lower corner.
            const int side = 4 * k / count;
            const double along = 8.0 * k / count - 2 * side - 1;
            const double turn = side < 2 ? 1 : -1;
            const double x = half[0] * (side % 2 == 0 ? turn * along : turn),
                         y = half[1] * (side % 2 == 0 ? -turn : turn * along);
            points.push_back(on_border(middle, x, y));
        }
        return points;
    }

  private:
    /// The point on the way from the middle to (x, y), a point of the rectangle, that is as far as
    /// the circle allows.
    std::array<double, 2> on_border(const std::array<double, 2>& middle, double x, double y) const {
        const double squared = x * x + y * y, along = middle[0] * x + middle[1] * y,
                     rest = radius * radius - middle[0] * middle[0] - middle[1] * middle[1];
        double share = 1;
        if (squared > 0)
            share = std::min(
                1.0, (std::sqrt(std::max(0.0, along * along + squared * rest)) - along) / squared);
        return {middle[0] + share * x, middle[1] + share * y};
    }
};

/// Heights of circles of latitude about the long axis, including the heights of corners, without
/// poles.
std::vector<double> latitudes(const Scb2& s, int segments, double pole) {
    std::vector<double> heights;
    const int belts = std::max(2, segments / 2);
    for (int i = 1; i < belts; ++i) heights.push_back(-s.r * sin_cos_turns(0.5 * i / belts).cos);
    const auto add = [&](double squared) {
        if (!(squared > 0)) return;
        heights.push_back(std::sqrt(squared));
        heights.push_back(-std::sqrt(squared));
    };
    for (const double k : {s.slabs[0].e, s.slabs[0].f}) {
        add(s.r * s.r - k * k);
        for (const double l : {s.slabs[1].e, s.slabs[1].f}) add(s.r * s.r - k * k - l * l);
    }
    for (const double l : {s.slabs[1].e, s.slabs[1].f}) add(s.r * s.r - l * l);
    std::sort(heights.begin(), heights.end());
    std::vector<double> kept;
    for (const double height : heights)
        if (std::abs(height) < s.r - pole && (kept.empty() || height - kept.back() > pole))
            kept.push_back(height);
    return kept;
}

}  // namespace

Mesh volume_mesh(const Scb2& s, int segments) {
    Mesh mesh;
    const double least = resolution(s.c, s.r);
    if (!(s.r > least)) return mesh;
    std::vector<std::size_t> flat;
    for (std::size_t i = 0; i < 2; ++i)
        if (s.slabs[i].e - s.slabs[i].f <= least) flat.push_back(i);
    if (flat.size() == 2) return mesh;
    const Vec3 &n = s.slabs[0].n, &m = s.slabs[1].n, axis = long_axis(s);
    const auto at = [&](const std::array<double, 2>& p, double height) {
        return Vec3(s.c + p[0] * n + p[1] * m + height * axis);
    };
    const std::vector<double> heights = latitudes(s, segments, std::max(1e-6 * s.r, least));

    if (flat.size() == 1) {
        // Up one side of the outline and down the other; a fan on either side of it.
        const std::size_t wide = 1 - flat[0];
        const auto corner = [&](double height, bool upper) {
            const Slice slice(s, height);
            std::array<double, 2> p{};
            p[wide] = upper ? slice.upper[wide] : slice.lower[wide];
            return at(p, height);
        };
        mesh.vertices.push_back(at({}, -s.r));
        for (const double height : heights) mesh.vertices.push_back(corner(height, true));
        mesh.vertices.push_back(at({}, s.r));
        for (std::size_t i = heights.size(); i-- > 0;)
            mesh.vertices.push_back(corner(heights[i], false));
        const std::uint32_t count = next_index(mesh);
        for (const bool front : {true, false}) {
            const std::uint32_t middle = next_index(mesh);
            std::array<double, 2> p{};
            p[wide] = (s.slabs[wide].e + s.slabs[wide].f) / 2;
            mesh.vertices.push_back(at(p, 0));
            for (std::uint32_t k = 0; k < count; ++k) {
                const std::uint32_t next = (k + 1) % count;
                mesh.triangles.push_back(front ? Triangle{middle, k, next}
                                               : Triangle{middle, next, k});
            }
        }
        return mesh;
    }

    const int corners = std::max(4, (segments + 3) / 4 * 4);
    const auto count = static_cast<std::uint32_t>(corners);
    mesh.vertices.push_back(at({}, -s.r));
    for (const double height : heights)
        for (const auto& p : Slice(s, height).border(corners))
            mesh.vertices.push_back(at(p, height));
    mesh.vertices.push_back(at({}, s.r));
    const std::uint32_t top = next_index(mesh) - 1;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t next = (k + 1) % count;
        mesh.triangles.push_back({0, 1 + next, 1 + k});
        std::uint32_t ring = 1;
        for (; ring + count < top; ring += count) {
            mesh.triangles.push_back({ring + k, ring + next, ring + count + next});
            mesh.triangles.push_back({ring + k, ring + count + next, ring + count + k});
        }
        mesh.triangles.push_back({top, ring + k, ring + next});
    }
    return mesh;
}

Mesh volume_mesh(const Ball& ball, int segments) {
    return volume_mesh(Scb{ball.center, ball.radius, Vec3::UnitZ(), ball.radius, -ball.radius},
                       segments);
}

Mesh volume_mesh(const Obb& box, int) {
    Mesh mesh;
    const double least = resolution(box.center, box.half.maxCoeff());
    std::vector<Eigen::Index> thick, flat;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        (box.half[axis] > least ? thick : flat).push_back(axis);
    if (flat.size() > 1) return mesh;
    if (flat.size() == 1) {
        const Vec3 x = box.axes.col(thick[0]) * box.half[thick[0]],
                   y = box.axes.col(thick[1]) * box.half[thick[1]];
        for (const Vec3& side : {Vec3(-x - y), Vec3(x - y), Vec3(x + y), Vec3(y - x)})
            mesh.vertices.push_back(box.center + side);
        // The two sides are cut along different diagonals, so that every edge has two triangles.
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {1, 3, 2}};
        return mesh;
    }
    for (int i = 0; i < 8; ++i) {
        const Vec3 corner((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
        mesh.vertices.push_back(box.center + box.axes * corner.cwiseProduct(box.half));
    }
    for (const auto& [a, b, c, d] : {std::array<std::uint32_t, 4>{0, 4, 6, 2},
                                     {1, 3, 7, 5},
                                     {0, 1, 5, 4},
                                     {2, 6, 7, 3},
                                     {0, 2, 3, 1},
                                     {4, 5, 7, 6}}) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    return mesh;
}

Mesh volume_mesh(const ConvexShape& shape, int segments) {
    // An even number, so that the grid includes the directions of the frame's faces.
    constexpr int most_steps = 12;
    const DirectionGrid grid = direction_grid(std::clamp((segments + 7) / 8 * 2, 2, most_steps));
    const double size = diameter(shape),
                 least = std::max(resolution(shape.center, size), 1e-9 * size);
    Mesh mesh;
    for (const std::vector<Vec3>& face :
         face_polygons(planes_about(shape, grid.directions), size)) {
        std::vector<std::uint32_t> corners;
        for (const Vec3& from_center : face) {
            const Vec3 point = shape.center + from_center;
            const auto same = std::find_if(
                mesh.vertices.begin(), mesh.vertices.end(),
                [&](const Vec3& p) { return ((p - point).cwiseAbs().array() <= least).all(); });
            const auto at = static_cast<std::uint32_t>(same - mesh.vertices.begin());
            if (same == mesh.vertices.end()) mesh.vertices.push_back(point);
            if (corners.empty() || (corners.back() != at && corners.front() != at))
                corners.push_back(at);
        }
        for (std::size_t k = 1; k + 1 < corners.size(); ++k)
            mesh.triangles.push_back({corners[0], corners[k], corners[k + 1]});
    }
    return mesh;
}

}  // namespace scb::scenes
