#include "core/hierarchy/bodies_inside.h"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "core/geometry/mesh_facts.h"

namespace scb {
namespace {

bool holds(const Box& box, const Vec3& p) {
    return (box.lower.array() <= p.array()).all() && (p.array() <= box.upper.array()).all();
}

bool overlap(const Box& a, const Box& b) { return gap_between(a, b).isZero(0); }

/// `parity` is called only if a vertex is in the other body's box.
PartsInside parts_inside(const Mesh& mesh, const MeshParts& parts, const Box& other,
                         bool other_is_closed, const std::function<const MeshParity&()>& parity) {
    PartsInside result;
    result.parts = parts.count;
    std::vector<bool> is_decided(parts.count);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const std::uint32_t part = parts.of_triangle[i];
        if (is_decided[part]) continue;
        const Vec3& vertex = mesh.vertices[mesh.triangles[i][0]];
        is_decided[part] = true;
        if (!holds(other, vertex)) continue;
        if (!other_is_closed) {
            result.not_judged = true;
            continue;
        }
        const PointSide side = parity().side(vertex);
        // If an overlap test missed contacts, a vertex may be on the other body. Another vertex of
        // the part decides then.
        is_decided[part] = side != PointSide::on;
        result.inside += side == PointSide::in;
    }
    return result;
}

}  // namespace

BodiesInside::BodiesInside(const Mesh& a, const Topology& of_a, const Mesh& b, const Topology& of_b)
    : sides_{Side{&a, &of_a, bounding_box(a), false, {}}, Side{&b, &of_b, {}, false, {}}} {}

void BodiesInside::prepare() {
    if (prepared_) return;
    prepared_ = true;
    for (Side& side : sides_) {
        std::vector<Triangle> joined = joined_triangles(*side.mesh);
        side.parts = mesh_parts(joined, side.mesh->vertices.size());
        side.is_closed = are_closed(std::move(joined));
    }
}

std::array<PartsInside, 2> BodiesInside::at(const Pose& b_to_a) {
    const Side &a = sides_[0], &b = sides_[1];
    const Box box_of_b = bounding_box(*b.mesh, b_to_a);
    if (!overlap(a.box, box_of_b)) return {};
    prepare();
    // Vertices that no triangle uses may be anywhere, and have no effect.
    Mesh placed{b.mesh->vertices, b.mesh->triangles};
    for (Vec3& vertex : placed.vertices) vertex = transform_point(b_to_a, vertex);
    std::optional<MeshParity> parity_of_b;
    const auto of_a = [&]() -> const MeshParity& {
        if (!parity_of_a_) parity_of_a_.emplace(*a.mesh, *a.topology);
        return *parity_of_a_;
    };
    const auto of_b = [&]() -> const MeshParity& {
        if (!parity_of_b) parity_of_b.emplace(placed, *b.topology);
        return *parity_of_b;
    };
    return {parts_inside(*a.mesh, a.parts, box_of_b, b.is_closed, of_b),
            parts_inside(placed, b.parts, a.box, a.is_closed, of_a)};
}

}  // namespace scb
