#pragma once

#include "core/judge/query_check.h"

namespace scb {

/// Adds what the tests of a query that passed led to: of a node that was divided, each child is
/// tested, unless the engine knows better, or forgets one.
DivisionCounts check_divisions(const EngineQuery& query, std::span<const JudgedTest> tests);

}  // namespace scb
