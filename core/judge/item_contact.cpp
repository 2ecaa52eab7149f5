#include "core/judge/item_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/triangle_segment.h"
#include "core/judge/query_contacts.h"
#include "scb/triangle_distance.h"
#include "scb/triangle_overlap.h"

namespace scb {
namespace {

/// The two triangles, in A's frame.
std::array<TriangleCorners, 2> triangles_of(const EngineQuery& query, const Pose& b_to_a,
                                            IndexPair items) {
    return {corners(*query.sides[0].mesh, items.a),
            transform_corners(b_to_a, corners(*query.sides[1].mesh, items.b))};
}

double tolerance_of_objects(const EngineQuery& query, IndexPair objects) {
    const IndexPair leaves{query.sides[0].shape->holder_of(objects.a),
                           query.sides[1].shape->holder_of(objects.b)};
    return leaves.a == no_index || leaves.b == no_index ? query.tolerance
                                                        : tolerance_of(query, leaves);
}

}  // namespace

bool has_finite_corners(const Mesh& mesh, std::uint32_t triangle) {
    const TriangleCorners of = corners(mesh, triangle);
    return std::all_of(of.begin(), of.end(), is_usable);
}

bool has_no_area(const Mesh& mesh, std::uint32_t triangle) {
    const TriangleCorners of = corners(mesh, triangle);
    return has_finite_corners(mesh, triangle) &&
           !(squared_norm(cross(Vec3(of[1] - of[0]), Vec3(of[2] - of[0]))) > 0);
}

bool has_items(const EngineQuery& query, IndexPair items) {
    const auto has = [](const EngineSide& side, std::uint32_t item) {
        if (side.mesh) return item < side.mesh->triangles.size();
        return side.shape->holder.empty() || side.shape->holder_of(item) != no_index ||
               side.tree->object_volume(item);
    };
    return has(query.sides[0], items.a) && has(query.sides[1], items.b);
}

bool are_finite(const EngineQuery& query, IndexPair items) {
    const auto finite = [](const EngineSide& side, std::uint32_t item) {
        return !side.mesh || has_finite_corners(*side.mesh, item);
    };
    return finite(query.sides[0], items.a) && finite(query.sides[1], items.b);
}

ItemContact contact_of(const EngineQuery& query, const Pose& b_to_a, IndexPair items) {
    if (has_object_volumes(query)) {
        const NodeVolume *a = volume_of_object(query.sides[0], items.a),
                         *b = volume_of_object(query.sides[1], items.b);
        // Without a volume the contact is touching, which claims nothing.
        const ContactCertificate found =
            a && b ? exact_verdict(*a, *b, b_to_a, tolerance_of_objects(query, items))
                   : ContactCertificate{};
        return {found.contact == Contact::overlapping, found.contact == Contact::touching,
                found.margin};
    }
    const auto [a, b] = triangles_of(query, b_to_a, items);
    if (query.kind == QueryKind::within) {
        const double over = triangle_distance(a, b).distance - query.limit;
        return {over <= 0, std::abs(over) <= query.triangle_tolerance, std::abs(over)};
    }
    const bool meet = triangles_overlap(a, b);
    const double margin = meet ? triangle_depth(a, b) : triangle_distance(a, b).distance;
    return {meet, margin <= query.triangle_tolerance, margin};
}

bool have_meshes(const EngineQuery& query) { return query.sides[0].mesh && query.sides[1].mesh; }

std::optional<double> error_of(const EngineQuery& query, const Pose& b_to_a,
                               const EngineEvent& event) {
    const IndexPair items{event.a, event.b};
    if (!has_items(query, items)) return std::nullopt;
    if (query.kind != QueryKind::collide && !have_meshes(query)) return std::nullopt;
    if (has_object_volumes(query)) {
        if (event.kind != EngineEvent::Kind::items_meet ||
            !query.sides[0].tree->object_volume(items.a) ||
            !query.sides[1].tree->object_volume(items.b))
            return std::nullopt;
        const ItemContact contact = contact_of(query, b_to_a, items);
        return contact.meet || contact.grazing ? std::nullopt : std::optional(contact.margin);
    }
    if (!have_meshes(query) || !are_finite(query, items)) return std::nullopt;
    const auto [a, b] = triangles_of(query, b_to_a, items);
    if (query.kind != QueryKind::collide) {
        const double exact = triangle_distance(a, b).distance;
        if (!event.has_length) {
            if (query.kind == QueryKind::distance) return std::nullopt;
            const ItemContact contact = contact_of(query, b_to_a, items);
            return contact.grazing || contact.meet == (event.kind == EngineEvent::Kind::items_meet)
                       ? std::nullopt
                       : std::optional(contact.margin);
        }
        if (std::isnan(event.length)) return HUGE_VAL;
        // An engine that gave up, since the two are too far apart to matter, has no distance.
        const double error = std::abs(event.length - exact);
        if (std::isinf(event.length) || error <= query.triangle_tolerance) return std::nullopt;
        // Some engines return a depth, as a negative number, for triangles that meet.
        if (exact <= query.triangle_tolerance && event.length < 0) return std::nullopt;
        return error;
    }
    if (triangles_overlap(a, b) == (event.kind == EngineEvent::Kind::items_meet))
        return std::nullopt;
    const ItemContact contact = contact_of(query, b_to_a, items);
    return contact.grazing ? std::nullopt : std::optional(contact.margin);
}

}  // namespace scb
