#pragma once

#include <optional>

#include "core/judge/engine_query.h"

namespace scb {

/// Whether two items, triangles or objects, are a pair (`meet`): they intersect or, in a query for
/// triangles within a tolerance, are so near. `grazing`: this depends on less than the tolerance of
/// the engine's numbers.
struct ItemContact {
    bool meet = false, grazing = false;
    /// Gap or depth, a lower bound for objects; the difference of the distance from the limit.
    double margin = 0;
};

/// Whether both sides have triangles.
bool have_meshes(const EngineQuery& query);

/// Whether both items exist.
bool has_items(const EngineQuery& query, IndexPair items);

/// Whether the corners of both items are finite. The items must exist.
bool are_finite(const EngineQuery& query, IndexPair items);

/// The items must be finite. An object without an extent grazes every other object.
ItemContact contact_of(const EngineQuery& query, const Pose& b_to_a, IndexPair items);

/// The gap or depth of two items if their test was wrong by more than the tolerance; in a query of
/// distances the error of the recorded distance, infinity if it is none. The extents of objects are
/// bounds: they can prove that two objects are apart, but not that they meet.
std::optional<double> error_of(const EngineQuery& query, const Pose& b_to_a,
                               const EngineEvent& event);

}  // namespace scb
