#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/judge/node_tree.h"
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

    friend bool operator==(const EngineEvent&, const EngineEvent&) = default;
};

/// One of the two trees of a query. Refers, does not own.
struct EngineSide {
    const NodeTree* tree = nullptr;
    const TreeShape* shape = nullptr;
    /// nullptr: items are no triangles. Vertices need not be finite, see has_finite_corners.
    const Mesh* mesh = nullptr;
    /// Items are objects, each alone in a leaf, whose volume is all that is known of them.
    bool objects_by_volume = false;
    int version = 0;  ///< another one whenever anything of this tree, or of its mesh, has changed
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
    /// Lengths up to which the engine's arithmetic may differ from exact one: of volumes, and of
    /// triangles.
    double tolerance = 0, triangle_tolerance = 0;
    /// The largest |coordinate| of the places of both bodies, which the tolerance follows.
    double away = 0;
    bool single = false;  ///< the engine's numbers are of 32 bits
};

/// Whether all coordinates are numbers of at most max_coordinate.
inline bool is_usable(const Vec3& point) { return (point.array().abs() <= max_coordinate).all(); }

/// Whether all corners of the triangle are usable.
bool has_finite_corners(const Mesh& mesh, std::uint32_t triangle);

}  // namespace scb
