#pragma once

#include <vector>

#include "core/judge/engine_query.h"

namespace scb {

/// The extent of an object that was recorded; where none was, the volume of its leaf; nullptr where
/// it has no leaf either.
const NodeVolume* volume_of_object(const EngineSide& side, std::uint32_t object);

/// Whether the results of the query can be judged by volumes: its items are objects, each alone in
/// a leaf.
bool has_object_volumes(const EngineQuery& query);

/// All pairs of objects whose volumes are not disjoint, see volume_of_object: sorted; of a body
/// against itself each pair once, and no object with itself. Swept along x.
std::vector<IndexPair> object_contacts(const EngineQuery& query);

}  // namespace scb
