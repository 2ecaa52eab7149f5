#include "tests/samples/sample_meshes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "core/base/portable_math.h"

namespace scb::samples {
namespace {

/// Points of a plane, counterclockwise.
using Loop = std::vector<std::array<double, 2>>;

/// From `first` to `last` of `parts` equal parts of a turn, with both ends.
Loop arc(std::array<double, 2> center, double radius, int first, int last, int parts) {
    Loop points;
    for (int i = first; i <= last; ++i) {
        const SinCos angle = sin_cos_turns(static_cast<double>(i) / parts);
        points.push_back({center[0] + radius * angle.cos, center[1] + radius * angle.sin});
    }
    return points;
}

Loop circle(std::array<double, 2> center, double radius, int sides) {
    return arc(center, radius, 0, sides - 1, sides);
}

double squared_distance(const std::array<double, 2>& a, const std::array<double, 2>& b) {
    const double x = a[0] - b[0], y = a[1] - b[1];
    return x * x + y * y;
}

/// Twice the area of a triangle, positive where it is counterclockwise.
double area2(const std::array<double, 2>& a, const std::array<double, 2>& b,
             const std::array<double, 2>& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// A mesh made of flat faces and walls; points at the same place are one vertex.
class Solid {
  public:
    /// Where a plane lies: its axes u and v, and its height along the third axis, which is u x v.
    struct Plane {
        int u, v;
        double height;
    };

    void add_triangle(const Plane& plane, const std::array<double, 2>& a,
                      const std::array<double, 2>& b, const std::array<double, 2>& c, bool up) {
        const std::uint32_t i = vertex(plane, a), j = vertex(plane, b), k = vertex(plane, c);
        mesh_.triangles.push_back(up ? Triangle{i, j, k} : Triangle{i, k, j});
    }

    /// A convex face, as a fan.
    void add_face(const Plane& plane, const Loop& outside, bool up) {
        for (std::size_t i = 1; i + 1 < outside.size(); ++i)
            add_triangle(plane, outside[0], outside[i], outside[i + 1], up);
    }

    /// A convex face with one round hole: each next triangle takes the shorter of two edges
    /// that does not cross the hole.
    void add_ring(const Plane& plane, const Loop& outside, const Loop& hole, bool up) {
        std::size_t start = 0;
        for (std::size_t j = 0; j < hole.size(); ++j)
            if (squared_distance(outside[0], hole[j]) < squared_distance(outside[0], hole[start]))
                start = j;
        std::size_t i = 0, j = 0;
        while (i < outside.size() || j < hole.size()) {
            const auto at = [&](std::size_t k) { return hole[(start + k) % hole.size()]; };
            const auto &o = outside[i % outside.size()],
                       &next_o = outside[(i + 1) % outside.size()];
            const auto h = at(j), next_h = at(j + 1), previous_h = at(j + hole.size() - 1);
            const bool along_hole = j < hole.size() && area2(o, next_h, h) > 0,
                       along_outside = i < outside.size() && (area2(next_o, next_h, h) > 0 ||
                                                              area2(next_o, h, previous_h) > 0);
            const bool outer = along_outside && (!along_hole || squared_distance(next_o, h) <
                                                                    squared_distance(o, next_h));
            add_triangle(plane, o, outer ? next_o : next_h, h, up);
            ++(outer ? i : j);
        }
    }

    /// The wall from `lower` to `upper` along a line of points; `closed` also from the last point
    /// to the first.
    void add_wall(const Plane& lower, double upper, const Loop& line, bool closed, bool outward) {
        const Plane top{lower.u, lower.v, upper};
        for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
            const auto &a = line[i], &b = line[(i + 1) % line.size()];
            const std::uint32_t p = vertex(lower, a), q = vertex(lower, b), r = vertex(top, b),
                                s = vertex(top, a);
            mesh_.triangles.push_back(outward ? Triangle{p, q, r} : Triangle{p, r, q});
            mesh_.triangles.push_back(outward ? Triangle{p, r, s} : Triangle{p, s, r});
        }
    }

    Mesh take() { return std::move(mesh_); }

  private:
    std::uint32_t vertex(const Plane& plane, const std::array<double, 2>& at) {
        std::array<double, 3> point{};
        point[static_cast<std::size_t>(plane.u)] = at[0];
        point[static_cast<std::size_t>(plane.v)] = at[1];
        point[static_cast<std::size_t>(3 - plane.u - plane.v)] = plane.height;
        const auto [place, is_new] =
            indices_.emplace(point, static_cast<std::uint32_t>(mesh_.vertices.size()));
        if (is_new) mesh_.vertices.emplace_back(point[0], point[1], point[2]);
        return place->second;
    }

    Mesh mesh_;
    std::map<std::array<double, 3>, std::uint32_t> indices_;
};

void add_plate(Solid& solid) {
    const Solid::Plane bottom{0, 1, 0}, top{0, 1, 10};
    const Loop holes[] = {circle({-50, -20}, 9, 32), circle({-50, 20}, 9, 32),
                          circle({50, -20}, 9, 32), circle({50, 20}, 9, 32)};
    // The points at y = -28 and 28 are corners of the lugs, and lie on the top alone.
    const Loop below[] = {{{-70, -40}, {-30, -40}, {-30, 0}, {-70, 0}},
                          {{-70, 0}, {-30, 0}, {-30, 40}, {-70, 40}},
                          {{30, -40}, {70, -40}, {70, 0}, {30, 0}},
                          {{30, 0}, {70, 0}, {70, 40}, {30, 40}}};
    const Loop above[] = {{{-70, -40}, {-30, -40}, {-30, -28}, {-30, 0}, {-70, 0}},
                          {{-70, 0}, {-30, 0}, {-30, 28}, {-30, 40}, {-70, 40}},
                          {{30, -40}, {70, -40}, {70, 0}, {30, 0}, {30, -28}},
                          {{30, 0}, {70, 0}, {70, 40}, {30, 40}, {30, 28}}};
    for (int i = 0; i < 4; ++i) {
        solid.add_ring(bottom, below[i], holes[i], false);
        solid.add_ring(top, above[i], holes[i], true);
        solid.add_wall(bottom, top.height, holes[i], true, false);
    }
    const Loop middle = circle({0, 0}, 16, 48);
    solid.add_ring(bottom, {{-30, -40}, {30, -40}, {30, 0}, {30, 40}, {-30, 40}, {-30, 0}}, middle,
                   false);
    solid.add_ring(top, {{-30, -28}, {30, -28}, {30, 0}, {30, 28}, {-30, 28}, {-30, 0}}, middle,
                   true);
    solid.add_wall(bottom, top.height, middle, true, false);
    solid.add_wall(bottom, top.height,
                   {{-70, -40},
                    {-30, -40},
                    {30, -40},
                    {70, -40},
                    {70, 0},
                    {70, 40},
                    {30, 40},
                    {-30, 40},
                    {-70, 40},
                    {-70, 0}},
                   true, true);
}

/// A lug on the plate, from y = `from` to `to`: a half disc of radius 30 on a rectangle, with a
/// hole of radius 12.
void add_lug(Solid& solid, double from, double to) {
    const Solid::Plane front{2, 0, from}, back{2, 0, to};  // (z, x): their third axis is +y
    Loop outline = arc({45, 0}, 30, -12, 12, 48);
    outline.insert(outline.begin(), {10, -30});
    outline.push_back({10, 30});
    const Loop hole = circle({45, 0}, 12, 48);
    solid.add_ring(front, outline, hole, false);
    solid.add_ring(back, outline, hole, true);
    solid.add_wall(front, to, outline, false, true);
    solid.add_wall(front, to, hole, true, false);
}

template <typename... Numbers>
void print(std::string& text, const char* format, Numbers... numbers) {
    char line[128];
    std::snprintf(line, sizeof line, format, numbers...);
    text += line;
}

void print_vertex(std::string& text, const char* format, const Vec3& v) {
    const auto rounded = [](double x) { return std::round(x * 1e4) / 1e4 + 0.0; };  // -0 becomes 0
    print(text, format, rounded(v[0]), rounded(v[1]), rounded(v[2]));
}

}  // namespace

Mesh bracket() {
    Solid solid;
    add_plate(solid);
    add_lug(solid, -40, -28);
    add_lug(solid, 28, 40);
    return solid.take();
}

Mesh pin() {
    constexpr int sides = 40;
    struct Ring {
        double radius, y;
    };
    // Head, shaft, and a chamfer at the tip.
    constexpr Ring rings[] = {{18, -63}, {18, -55}, {11.5, -55}, {11.5, 50}, {9.5, 53}};
    Mesh mesh;
    for (const Ring& ring : rings)
        for (const auto& [z, x] : circle({0, 0}, ring.radius, sides))
            mesh.vertices.emplace_back(x, ring.y, z);
    mesh.vertices.emplace_back(0, -63, 0);
    mesh.vertices.emplace_back(0, 53, 0);
    constexpr std::uint32_t count = sides, last = 4 * count, head = 5 * count, tip = head + 1;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = (i + 1) % count;
        for (std::uint32_t ring = 0; ring < last; ring += count) {
            mesh.triangles.push_back({ring + i, ring + next, ring + count + next});
            mesh.triangles.push_back({ring + i, ring + count + next, ring + count + i});
        }
        mesh.triangles.push_back({head, next, i});
        mesh.triangles.push_back({tip, last + i, last + next});
    }
    return mesh;
}

std::string ply_text(const Mesh& mesh) {
    std::string text = "ply\nformat ascii 1.0\n";
    print(text, "element vertex %zu\n", mesh.vertices.size());
    text += "property float x\nproperty float y\nproperty float z\n";
    print(text, "element face %zu\n", mesh.triangles.size());
    text += "property list uchar int vertex_indices\nend_header\n";
    for (const Vec3& v : mesh.vertices) print_vertex(text, "%.9g %.9g %.9g\n", v);
    for (const Triangle& t : mesh.triangles) print(text, "3 %u %u %u\n", t[0], t[1], t[2]);
    return text;
}

std::string obj_text(const Mesh& mesh) {
    std::string text;
    for (const Vec3& v : mesh.vertices) print_vertex(text, "v %.9g %.9g %.9g\n", v);
    for (const Triangle& t : mesh.triangles)
        print(text, "f %u %u %u\n", t[0] + 1, t[1] + 1, t[2] + 1);
    return text;
}

}  // namespace scb::samples
