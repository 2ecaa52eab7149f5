#pragma once

#include <algorithm>

#include "tests/core/hierarchy/built_mesh.h"
#include "tests/core/overlap/volume_pairs.h"
#include "tests/unless_sanitized.h"

namespace scb {

/// How many small scenes a test tries.
inline constexpr int scenes_tried = unless_sanitized(1000, 20);

/// Corners on a grid of dyadic coordinates, most of them shared.
inline Mesh grid_soup(Random& random, int count, std::uint32_t size) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        Triangle t;
        for (std::uint32_t& corner : t) {
            if (mesh.vertices.size() > 2 && random.below(3) == 0) {
                corner = random.below(static_cast<std::uint32_t>(mesh.vertices.size()));
                continue;
            }
            corner = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.emplace_back(random.below(size) / 4.0, random.below(size) / 4.0,
                                       random.below(size) / 4.0);
        }
        mesh.triangles.push_back(t);
    }
    return mesh;
}

/// A flat patch of a height that is one of few, so that two of them are coplanar now and then.
inline Mesh flat_patch(Random& random, int count) {
    Mesh mesh = height_field(4);
    const double height = random.below(2) / 4.0;
    for (Vec3& v : mesh.vertices) v[2] = height;
    mesh.triangles.resize(static_cast<std::size_t>(std::min(count, 32)));
    return mesh;
}

inline void degenerate_some(Mesh& mesh, Random& random) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Triangle& t = mesh.triangles[i];
        const std::uint32_t kind = random.below(12);
        if (kind == 0) t[1] = t[0];
        if (kind == 1) t[1] = t[2] = t[0];
        if (kind == 2) t = mesh.triangles[random.below(static_cast<std::uint32_t>(i + 1))];
        if (kind == 3) mesh.vertices[t[2]] = (mesh.vertices[t[0]] + mesh.vertices[t[1]]) / 2;
    }
}

inline Mesh small_mesh(Random& random, int count) {
    const std::uint32_t kind = random.below(4);
    Mesh mesh = kind == 0   ? random_soup(random.next(), count, 0.3)
                : kind == 1 ? random_soup(random.next(), count, 1)
                : kind == 2 ? grid_soup(random, count, 3 + random.below(6))
                            : flat_patch(random, count);
    if (random.below(2) == 0) degenerate_some(mesh, random);
    return mesh;
}

inline Mat3 random_quarter_turn(Random& random) {
    Mat3 m = Mat3::Zero();
    const int first = static_cast<int>(random.below(3));
    const int step = 1 + static_cast<int>(random.below(2));
    for (int k = 0; k < 3; ++k) m((first + step * k) % 3, k) = random.below(2) == 0 ? 1 : -1;
    if (dot(cross(Vec3(m.col(0)), Vec3(m.col(1))), Vec3(m.col(2))) < 0) m.col(0) *= -1;
    return m;
}

/// Transforms dyadic coordinates without rounding, there and back.
inline Pose exact_pose(Random& random) {
    const auto part = [&] { return (static_cast<int>(random.below(9)) - 4) / 8.0; };
    return {random_quarter_turn(random), {part(), part(), part()}};
}

inline Pose small_pose(Random& random) {
    const std::uint32_t kind = random.below(4);
    if (kind == 0) return {};
    if (kind == 1) return exact_pose(random);
    return random_pose(random);
}

struct SmallScene {
    BuiltMesh a, b;
    Pose pose;
};

inline SmallScene small_scene(std::uint64_t seed) {
    Random random(seed);
    const auto count = [&] { return 1 + static_cast<int>(random.below(40)); };
    const Mesh a = small_mesh(random, count());
    if (random.below(5) == 0) return {BuiltMesh(a), BuiltMesh(a), Pose{}};
    return {BuiltMesh(a), BuiltMesh(small_mesh(random, count())), small_pose(random)};
}

}  // namespace scb
