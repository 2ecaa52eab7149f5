#pragma once

#include <cmath>
#include <initializer_list>
#include <vector>

#include "core/base/random.h"
#include "scb/mesh.h"

namespace scb {

inline Vec3 random_point(Random& random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

inline Vec3 random_unit_vector(Random& random) {
    for (;;) {
        const Vec3 v = random_point(random);
        const double squared = squared_norm(v);
        if (squared > 0.01 && squared <= 1) return v / std::sqrt(squared);
    }
}

/// `count` points of a box that is flattened along a random direction by `flatness`.
inline std::vector<Vec3> random_points(Random& random, int count, double flatness = 1) {
    const Vec3 n = random_unit_vector(random);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const Vec3 p = random_point(random);
        points.push_back(p - (1 - flatness) * dot(n, p) * n);
    }
    return points;
}

/// `count` triangles of about `size` in the cube [-1, 1]^3, no two sharing a vertex.
inline Mesh random_soup(std::uint64_t seed, int count, double size) {
    Random random(seed);
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vec3 center = random_point(random);
        Triangle t;
        for (std::uint32_t& corner : t) {
            corner = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(center + size * random_point(random));
        }
        mesh.triangles.push_back(t);
    }
    return mesh;
}

/// Two triangles for each of n x n quads whose corners are numbered row by row.
inline std::vector<Triangle> grid_triangles(int n) {
    std::vector<Triangle> triangles;
    const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return triangles;
}

/// A bumpy height field of n x n quads over [0, 1]^2, two triangles each, vertices shared.
inline Mesh height_field(int n) {
    Mesh mesh;
    Random random(7);
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            mesh.vertices.emplace_back(double(i) / n, double(j) / n, 0.3 / n * random.uniform());
    mesh.triangles = grid_triangles(n);
    return mesh;
}

inline void append(Mesh& mesh, const Mesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// Soups of these numbers of triangles, a height field, one triangle fifty times, triangles that
/// are points, and a mesh far from the origin.
inline std::vector<Mesh> assorted_meshes(std::uint64_t seed, std::initializer_list<int> counts) {
    std::vector<Mesh> meshes;
    for (const int count : counts) meshes.push_back(random_soup(seed, count, 0.3));
    meshes.push_back(height_field(20));
    Mesh same{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    same.triangles.assign(50, {0, 1, 2});
    meshes.push_back(same);
    Mesh point{{{1, 2, 3}}, {}};
    point.triangles.assign(33, {0, 0, 0});
    meshes.push_back(point);
    Mesh far = height_field(8);
    for (Vec3& v : far.vertices) v += Vec3(1e6, -1e6, 1e6);
    meshes.push_back(far);
    return meshes;
}

}  // namespace scb
