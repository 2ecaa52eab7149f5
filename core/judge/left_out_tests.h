#pragma once

#include <vector>

#include "core/judge/engine_query.h"

namespace scb {

/// In a query of distances, per test of volumes: whether no test followed it, so that its recorded
/// bound left its nodes out. Empty in other queries.
///
/// In doubt a test left nothing out: if a repeated test of the nodes led on, if the triangles of
/// two leaves were measured elsewhere, and if pairs were reported below nodes that were not tested.
std::vector<bool> left_out_tests(const EngineQuery& query);

}  // namespace scb
