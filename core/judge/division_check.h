#pragma once

#include "core/judge/query_check.h"

namespace scb {

/// Counts the tests that divided a node, and those of them that led to no test of a child although
/// its volume overlaps the other node, or each node that was tested in place of that. Of a child
/// that is apart from it, a test need not be recorded.
DivisionCounts check_divisions(const EngineQuery& query, std::span<const JudgedTest> tests);

}  // namespace scb
