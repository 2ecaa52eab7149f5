#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/analysis/trace.h"

namespace scb {

/// Tests per outcome, indexed by Stage.
using EndingCounts = std::array<std::uint64_t, StageTable::most_rows>;

/// How the tests of a frame ended, by the depth of the pair: the depths of both nodes added.
std::vector<EndingCounts> endings_by_depth(const QueryTrace& frame, const Outcomes& outcomes);

/// The same for all depths together.
EndingCounts ending_counts(const Outcomes& outcomes);

/// The endings that queries of this kind can have, in order: the stages of the test; then
/// `triangles_apart` and `triangles_meet` if triangles are tested, else `found`; `neighbors` in a
/// self query; `left_over` last.
std::vector<Stage> endings_of(VolumeKind volume, const CollideOptions& options,
                              QueryKind kind = QueryKind::collide);
std::vector<Stage> endings_of(const TraceHeader& header);

/// The number of tests of a frame per stage, for this project's tests and other engines':
/// "overlapping" first, then all stages in order, also stages without a test.
std::vector<std::pair<std::string, std::uint64_t>> tests_by_stage(const TraceHeader& header,
                                                                  const QueryTrace& frame);

/// The ending of this name among endings_of, if any.
std::optional<Stage> ending_of(const TraceHeader& header, std::string_view name);

}  // namespace scb
