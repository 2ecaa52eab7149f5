#include "core/judge/mapped_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace scb {
namespace {

using SharedPolytope = std::shared_ptr<const Polytope>;

/// Two columns are at right angles if the cosine of their angle is at most this.
constexpr double right_angle = 1e-9;

Vec3 unit(const Vec3& v) { return v / std::sqrt(squared_norm(v)); }

NodeVolume mapped_box(const Obb& box, const Mat3& map) {
    std::array<Vec3, 3> sides;
    std::array<double, 3> lengths{};
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        sides[k] = rotate(map, Vec3(box.axes.col(i)));
        lengths[k] = std::sqrt(squared_norm(sides[k]));
    }
    const Vec3 center = rotate(map, box.center);
    double skew = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        skew = std::max(skew, std::abs(dot(sides[k], sides[next])) / (lengths[k] * lengths[next]));
    }
    if (skew <= right_angle) {
        Obb result{center, Mat3::Identity(), Vec3::Zero()};
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            result.axes.col(i) = sides[k] / lengths[k];
            result.half[i] = box.half[i] * lengths[k];
        }
        if (dot(cross(result.axes.col(0), result.axes.col(1)), result.axes.col(2)) < 0)
            result.axes.col(0) = -result.axes.col(0);
        return result;
    }
    auto result = std::make_shared<Polytope>();
    result->center = center;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 p = Vec3::Zero();
        for (int i = 0; i < 3; ++i)
            p +=
                (corner >> i & 1 ? box.half[i] : -box.half[i]) * sides[static_cast<std::size_t>(i)];
        result->corners.push_back(p);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 normal = unit(cross(sides[(k + 1) % 3], sides[(k + 2) % 3]));
        const double offset = std::abs(dot(normal, sides[k])) * box.half[static_cast<int>(k)];
        result->faces.push_back({normal, offset});
        result->faces.push_back({-normal, offset});
    }
    return result;
}

NodeVolume mapped_polytope(const Polytope& polytope, const Mat3& map) {
    auto result = std::make_shared<Polytope>();
    result->center = rotate(map, polytope.center);
    for (const Vec3& corner : polytope.corners) result->corners.push_back(rotate(map, corner));
    // Normals are mapped by the transposed inverse.
    Mat3 normals;
    for (int i = 0; i < 3; ++i)
        normals.col(i) = cross(Vec3(map.col((i + 1) % 3)), Vec3(map.col((i + 2) % 3)));
    normals /= determinant(map);
    for (const FacePlane& face : polytope.faces) {
        const Vec3 normal = rotate(normals, face.normal);
        const double length = std::sqrt(squared_norm(normal));
        result->faces.push_back({normal / length, face.offset / length});
    }
    return result;
}

NodeVolume mapped_open_box(const OpenBox& box, const Mat3& map) {
    if (!map.isDiagonal(right_angle)) return {};
    OpenBox result;
    for (int i = 0; i < 3; ++i) {
        const double scale = map(i, i), from = box.lower[i] * scale, to = box.upper[i] * scale;
        result.lower[i] = std::min(from, to);
        result.upper[i] = std::max(from, to);
    }
    return result;
}

/// Maps a volume by a map that keeps angles and scales lengths by `scale`.
struct Similar {
    const Mat3& map;
    double scale;

    Vec3 direction(const Vec3& v) const { return rotate(map, v) / scale; }
    Slab slab(const Slab& s) const { return {direction(s.n), scale * s.e, scale * s.f}; }

    NodeVolume operator()(const Ball& ball) const {
        return Ball{rotate(map, ball.center), scale * ball.radius};
    }
    NodeVolume operator()(const Capsule& v) const {
        return Capsule{rotate(map, v.center), rotate(map, v.half_axis), scale * v.radius};
    }
    NodeVolume operator()(const Rss& v) const {
        return Rss{rotate(map, v.center),
                   {rotate(map, v.half_sides[0]), rotate(map, v.half_sides[1])},
                   scale * v.radius};
    }
    NodeVolume operator()(const Scb& v) const {
        return Scb{rotate(map, v.c), scale * v.r, direction(v.n), scale * v.e, scale * v.f};
    }
    NodeVolume operator()(const Scb2& v) const {
        return Scb2{rotate(map, v.c), scale * v.r, {slab(v.slabs[0]), slab(v.slabs[1])}};
    }
};

}  // namespace

double determinant(const Mat3& map) {
    return dot(cross(Vec3(map.col(0)), Vec3(map.col(1))), Vec3(map.col(2)));
}

std::optional<double> uniform_scale(const Mat3& map) {
    const double scale = std::sqrt(squared_norm(Vec3(map.col(0))));
    if (!(scale > 0)) return std::nullopt;
    const Mat3 turn = map / scale, off = turn.transpose() * turn - Mat3::Identity();
    if (!(off.cwiseAbs().maxCoeff() <= right_angle)) return std::nullopt;
    return scale;
}

NodeVolume mapped(const NodeVolume& volume, const Mat3& map) {
    return std::visit(
        [&]<class V>(const V& v) -> NodeVolume {
            if constexpr (std::is_same_v<V, std::monostate>) {
                return v;
            } else if constexpr (std::is_same_v<V, Obb>) {
                return mapped_box(v, map);
            } else if constexpr (std::is_same_v<V, OpenBox>) {
                return mapped_open_box(v, map);
            } else if constexpr (std::is_same_v<V, SharedPolytope>) {
                return mapped_polytope(*v, map);
            } else {
                const std::optional<double> scale = uniform_scale(map);
                return scale ? Similar{map, *scale}(v) : NodeVolume{};
            }
        },
        volume);
}

EngineNodes mapped(EngineNodes tree, const Mat3& map) {
    tree.change_volumes([&map](const NodeVolume& volume) { return mapped(volume, map); });
    return tree;
}

Mesh mapped(Mesh mesh, const Mat3& map) {
    for (Vec3& vertex : mesh.vertices) vertex = rotate(map, vertex);
    return mesh;
}

}  // namespace scb
