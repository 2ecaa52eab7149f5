#pragma once

#include <cstddef>
#include <vector>

#include "core/judge/engine_query.h"

namespace scb {

/// level_overlaps of an engine's two trees, by the exact verdict. Volumes that touch, and nodes
/// without a volume, count as overlapping. Empty for a self query, and if a pose is unusable.
std::vector<std::size_t> level_overlaps(const EngineQuery& query, std::size_t most);

}  // namespace scb
