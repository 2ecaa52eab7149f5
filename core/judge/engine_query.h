#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/model/engine_nodes.h"
#include "scb/collide.h"
#include "scb/mesh.h"
#include "scb/observer.h"

namespace scb {

/// One action of an engine in a query.
struct EngineEvent {
    enum class Kind : std::uint8_t {
        volumes,      ///< tested two volumes
        items_apart,  ///< tested two items
        items_meet,
        pair,  ///< reported two items
    };
    Kind kind = Kind::volumes;
    std::uint8_t stage = 0;      ///< `volumes`: number of the stage that rejected; 0: overlap
    std::uint32_t a = 0, b = 0;  ///< numbers of nodes, or items
    /// `volumes`: the recorded index, among the tests of volumes of this query, of the earlier test
    /// that led to this one. Its nodes are these nodes or above them. no_index: not recorded.
    std::uint32_t parent = no_index;
    /// A lower bound of the distance of two volumes, or the distance of two items, as recorded: any
    /// number. Only if `has_length`.
    double length = 0;
    bool has_length = false;

    friend bool operator==(const EngineEvent&, const EngineEvent&) = default;
};

/// One of the two trees of a query. Non-owning.
struct EngineSide {
    const EngineNodes* tree = nullptr;
    const TreeShape* shape = nullptr;
    /// nullptr: the items are not triangles. Vertices may be non-finite, see has_finite_corners.
    const Mesh* mesh = nullptr;
    /// The mesh in its first state, all vertices finite. Vertices that share a position in it count
    /// as one vertex. nullptr: `mesh` itself.
    const Mesh* rest = nullptr;
    /// Each item is an object alone in its leaf, known by its volume only.
    bool objects_by_volume = false;
    /// The largest |coordinate| of the tree's volumes and mesh (`reach`), and of the mesh alone,
    /// both before the pose scales the body by `stretch`.
    double reach = 0, mesh_reach = 0, stretch = 1;
    int version = 0;  ///< changes whenever the tree or its mesh changes
};

/// What contributes most to a tolerance.
enum class ToleranceCause {
    setting,   ///< the setting `tolerance` of the recording
    pose,      ///< the error of a body's rotation
    distance,  ///< the distance of a body from the origin
    reach,     ///< the coordinates of volumes and meshes
};

/// The answer of a recorded distance query.
struct EngineAnswer {
    double distance = 0;                          ///< as recorded: any number
    IndexPair items{no_index, no_index};          ///< the items with this distance, if recorded
    std::optional<std::array<Vec3, 2>> points{};  ///< of A and of B, in the world, if recorded
};

/// A recorded query of two trees.
struct EngineQuery {
    int frame = 0;
    std::array<EngineSide, 2> sides;
    QueryKind kind = QueryKind::collide;  ///< collide, distance or within
    /// distance: nothing beyond it is looked for; within: the tolerance.
    double limit = HUGE_VAL;
    double relative_error = 0;           ///< distance: the answer may be so much too large
    std::optional<EngineAnswer> answer;  ///< of a distance query, if it found something
    bool self = false;                   ///< one body against itself
    bool placed = true;                  ///< both poses are finite and keep the bodies' volumes
    Pose b_to_a, a_to_world;
    std::optional<Pose> b_to_a_before;  ///< the relative pose at the previous frame, if any
    std::vector<EngineEvent> events;
    /// Whether the recording has tests of items, and reported pairs, in this query or in another.
    bool has_item_tests = false, has_pairs = false;
    /// Whether the recording has distances that queries found, so that a missing one is none.
    bool has_answers = true;
    bool is_known = true;           ///< false: what the query measures is not known
    bool complete = true;           ///< false: the query ended early on purpose
    std::uint64_t nanoseconds = 0;  ///< 0: not measured
    /// The assumed rounding errors of the engine, as lengths: for the volumes that reach farthest
    /// (see tolerance_of), and for triangles.
    double tolerance = 0, triangle_tolerance = 0;
    double tolerance_slope = 0;  ///< growth of `tolerance` with a volume's stretched reach
    ToleranceCause tolerance_cause = ToleranceCause::reach;
    /// The largest |coordinate| of the positions of both bodies, and of their volumes and meshes.
    double away = 0, reach = 0;
    bool single = false;  ///< the engine's numbers have 32 bits
};

/// The key of two items, or of two nodes. In a self query both orders have the same key.
inline std::uint64_t pair_key(const EngineQuery& query, std::uint32_t a, std::uint32_t b) {
    if (query.self && a > b) std::swap(a, b);
    return std::uint64_t{a} << 32 | b;
}

/// The tolerance of two volumes with these reaches, measured before the stretch of the bodies.
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

/// Whether all |coordinates| are at most max_coordinate; false for NaN.
inline bool is_usable(const Vec3& point) { return (point.array().abs() <= max_coordinate).all(); }

/// Whether all corners of the triangle are usable.
bool has_finite_corners(const Mesh& mesh, std::uint32_t triangle);

/// Whether the corners are usable and lie on a line. Builders leave such triangles out.
bool has_no_area(const Mesh& mesh, std::uint32_t triangle);

}  // namespace scb
