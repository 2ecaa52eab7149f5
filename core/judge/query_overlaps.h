#pragma once

#include <cstddef>
#include <vector>

#include "core/judge/engine_query.h"

namespace scb {

/// What level_overlaps counts of the trees of an engine's query, by the exact verdict: volumes that
/// touch overlap, and so does a node without a volume. Nothing, where a body is tested against
/// itself, or its pose is not rigid.
std::vector<std::size_t> level_overlaps(const EngineQuery& query, std::size_t most);

}  // namespace scb
