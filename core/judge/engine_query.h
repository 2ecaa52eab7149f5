#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/model/engine_nodes.h"
#include "scb/mesh.h"
#include "scb/observer.h"

namespace scb {

/// What an engine did in a query, in its order.
struct EngineEvent {
    enum class Kind : std::uint8_t {
        volumes,      ///< tested two volumes
        items_apart,  ///< tested two items
        items_meet,
        pair,  ///< reported two items
    };
    Kind kind = Kind::volumes;
    std::uint8_t stage = 0;      ///< of volumes: at which they were rejected; 0: they overlap
    std::uint32_t a = 0, b = 0;  ///< numbers of nodes, or items
    /// Of volumes: number of the test of volumes in this query that led to this test, where the
    /// engine recorded it; an earlier test, of nodes at or above these nodes.
    std::uint32_t parent = no_index;

    friend bool operator==(const EngineEvent&, const EngineEvent&) = default;
};

/// One of the two trees of a query. Refers, does not own.
struct EngineSide {
    const EngineNodes* tree = nullptr;
    const TreeShape* shape = nullptr;
    /// nullptr: items are no triangles. Vertices need not be finite, see has_finite_corners.
    const Mesh* mesh = nullptr;
    /// The mesh as it was first, all of it finite: vertices at one place there are one vertex.
    /// nullptr: the mesh itself.
    const Mesh* rest = nullptr;
    /// Items are objects, each alone in a leaf, whose volume is all that is known of them.
    bool objects_by_volume = false;
    /// The largest |coordinate| of the tree's volumes and of its mesh, without the stretch of the
    /// body's pose, and the stretch.
    double reach = 0, mesh_reach = 0, stretch = 1;
    int version = 0;  ///< another one whenever anything of this tree, or of its mesh, has changed
};

/// The largest part of a tolerance.
enum class ToleranceCause {
    setting,   ///< the setting `tolerance` of the recording
    pose,      ///< the error of a body's rotation
    distance,  ///< the distance of a body from the origin
    reach,     ///< the coordinates of volumes and meshes
};

/// A query of two trees, as its engine tells of it.
struct EngineQuery {
    int frame = 0;
    std::array<EngineSide, 2> sides;
    bool self = false;   ///< of one body against itself
    bool placed = true;  ///< whether both bodies have a pose that keeps their volumes
    Pose b_to_a;
    std::optional<Pose> b_to_a_before;  ///< of the frame before, where there is one
    std::vector<EngineEvent> events;
    /// What of tests and results there is, in this query or in others of the same recording.
    bool tells_items = false, tells_pairs = false;
    bool complete = true;           ///< false: it ended early on purpose
    std::uint64_t nanoseconds = 0;  ///< 0: not measured
    /// Lengths up to which the engine's arithmetic may differ from exact one: of the volumes that
    /// reach farthest, see tolerance_of, and of triangles.
    double tolerance = 0, triangle_tolerance = 0;
    double tolerance_slope = 0;  ///< by how much `tolerance` grows with the reach of a volume
    ToleranceCause tolerance_cause = ToleranceCause::reach;
    /// The largest |coordinate| of the places of both bodies, and of their volumes and meshes.
    double away = 0, reach = 0;
    bool single = false;  ///< the engine's numbers are of 32 bits
};

/// Two items, or two nodes, in one number; of a body against itself the same in either order.
inline std::uint64_t pair_key(const EngineQuery& query, std::uint32_t a, std::uint32_t b) {
    if (query.self && a > b) std::swap(a, b);
    return std::uint64_t{a} << 32 | b;
}

/// The tolerance of volumes that reach so far, before the stretch of the bodies.
inline double tolerance_at(const EngineQuery& query, double reach_a, double reach_b) {
    double tolerance = query.tolerance;
    for (std::size_t k = 0; k < 2; ++k) {
        const EngineSide& side = query.sides[k];
        const double reach = std::max(k == 0 ? reach_a : reach_b, side.mesh_reach);
        tolerance -= query.tolerance_slope * side.stretch * std::max(0.0, side.reach - reach);
    }
    return std::max(tolerance, query.triangle_tolerance);
}

/// The tolerance of a test of these nodes.
inline double tolerance_of(const EngineQuery& query, IndexPair nodes) {
    return tolerance_at(query, (*query.sides[0].tree)[nodes.a].reach,
                        (*query.sides[1].tree)[nodes.b].reach);
}

/// Whether all coordinates are numbers of at most max_coordinate.
inline bool is_usable(const Vec3& point) { return (point.array().abs() <= max_coordinate).all(); }

/// Whether all corners of the triangle are usable.
bool has_finite_corners(const Mesh& mesh, std::uint32_t triangle);

/// Whether the corners lie on a line. Builders leave such triangles out.
bool has_no_area(const Mesh& mesh, std::uint32_t triangle);

}  // namespace scb
