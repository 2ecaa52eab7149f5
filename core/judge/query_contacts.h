#pragma once

#include <cstddef>
#include <vector>

#include "core/judge/engine_query.h"

namespace scb {

/// The recorded extent of an object, or else the volume of its leaf; nullptr if it has no leaf
/// either.
const NodeVolume* volume_of_object(const EngineSide& side, std::uint32_t object);

/// Whether the results of the query can be judged by volumes: its items are objects, each alone in
/// a leaf.
bool has_object_volumes(const EngineQuery& query);

/// All pairs of objects whose volumes are not disjoint, see volume_of_object: sorted. In a self
/// query each pair appears once, and no object with itself. Sweeps along the axis of greatest
/// spread.
std::vector<IndexPair> object_contacts(const EngineQuery& query);

/// level_overlaps of an engine's two trees, by the exact verdict. Volumes that touch, and nodes
/// without a volume, count as overlapping. Empty for a self query, and if a pose is unusable.
std::vector<std::size_t> level_overlaps(const EngineQuery& query, std::size_t most);

}  // namespace scb
