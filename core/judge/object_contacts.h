#pragma once

#include <vector>

#include "core/judge/engine_query.h"

namespace scb {

/// Whether the results of the query can be judged by volumes: its items are objects that nothing is
/// known of but the volumes of the leaves that hold them.
bool has_object_volumes(const EngineQuery& query);

/// All pairs of objects the volumes of whose leaves are not disjoint: sorted. Swept along x.
std::vector<IndexPair> object_contacts(const EngineQuery& query);

}  // namespace scb
