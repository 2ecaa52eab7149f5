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
    const Mesh* mesh = nullptr;  ///< nullptr: items are no triangles
    /// Items are objects, each alone in a leaf, whose volume is all that is known of them.
    bool objects_by_volume = false;
};

/// A query of two trees, as its engine tells of it.
struct EngineQuery {
    int frame = 0;
    std::array<EngineSide, 2> sides;
    bool self = false;  ///< of one body against itself
    bool rigid = true;  ///< whether both poses are
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
};

}  // namespace scb
