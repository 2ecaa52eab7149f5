#pragma once

#include "core/judge/query_check.h"

namespace scb {

/// Counts the tests that divided a node, and among them the tests that skipped a child. A child is
/// skipped if it was not tested although its volume overlaps the other node or, if both nodes were
/// divided, one of the other node's children. A child that overlaps neither need not be tested.
DivisionCounts check_divisions(const EngineQuery& query, std::span<const JudgedTest> tests);

}  // namespace scb
