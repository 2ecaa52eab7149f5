#pragma once

#include <optional>

#include "core/judge/engine_query.h"

namespace scb {

/// Whether two items, triangles or objects, intersect (`meet`), and whether the gap or depth is
/// within the tolerance (`grazing`).
struct ItemContact {
    bool meet = false, grazing = false;
    double margin = 0;  ///< gap or depth; a lower bound for objects
};

/// Whether both sides have triangles.
bool have_meshes(const EngineQuery& query);

/// Whether both items exist.
bool has_items(const EngineQuery& query, IndexPair items);

/// Whether the corners of both items are finite. The items must exist.
bool are_finite(const EngineQuery& query, IndexPair items);

/// The items must be finite. An object without an extent grazes every other object.
ItemContact contact_of(const EngineQuery& query, const Pose& b_to_a, IndexPair items);

/// The gap or depth of two items if their test was wrong by more than the tolerance. The extents of
/// objects are bounds: they can prove that two objects are apart, but not that they meet.
std::optional<double> error_of(const EngineQuery& query, const Pose& b_to_a,
                               const EngineEvent& event);

}  // namespace scb
