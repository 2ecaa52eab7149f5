#pragma once

#include "core/judge/query_check.h"

namespace scb {

/// Counts the tests that divided a node, and among them the tests that skipped a child. A child is
/// skipped if it overlaps the other node, but was not tested. If both nodes were divided, the other
/// node's children count in its place. A child that is apart need not be tested. `reach`: volumes
/// that are nearer than this distance count as overlapping.
DivisionCounts check_divisions(const EngineQuery& query, std::span<const JudgedTest> tests,
                               double reach = 0);

}  // namespace scb
