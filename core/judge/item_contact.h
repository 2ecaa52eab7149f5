#pragma once

#include <optional>

#include "core/judge/engine_query.h"

namespace scb {

/// Two items of a query, triangles or objects: whether they intersect, and whether that is within
/// the tolerance.
struct ItemContact {
    bool meet = false, grazing = false;
    double margin = 0;  ///< gap or depth; of volumes, at least
};

/// Whether both sides have triangles.
bool have_meshes(const EngineQuery& query);

/// Whether both items exist.
bool has_items(const EngineQuery& query, IndexPair items);

/// Whether the corners of both are finite; of items that exist.
bool are_finite(const EngineQuery& query, IndexPair items);

/// Of finite items. An object without an extent grazes each other one.
ItemContact contact_of(const EngineQuery& query, const Pose& b_to_a, IndexPair items);

/// The gap or depth of two items whose test erred by more than the tolerance. The extents of
/// objects are bounds: they prove that two objects are apart, and not that they meet.
std::optional<double> error_of(const EngineQuery& query, const Pose& b_to_a,
                               const EngineEvent& event);

}  // namespace scb
