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
std::vector<EndingCounts> endings_by_depth(const TraceFrame& frame, const Outcomes& outcomes);

/// The same for all depths together.
EndingCounts ending_counts(const TraceFrame& frame, const Outcomes& outcomes);

/// The endings that such queries can have, in order: the stages of the
/// test, then the others. `triangles_apart` and `triangles_meet` where
/// triangles were tested, else `found`; `left_over` last.
std::vector<Stage> endings_of(VolumeKind volume, const CollideOptions& options,
                              QueryKind kind = QueryKind::collide);
std::vector<Stage> endings_of(const TraceHeader& header);

/// The tests of a frame by how they ended, whoever made them: "overlapping" first, then the stages
/// in their order, those without a test too.
std::vector<std::pair<std::string, std::uint64_t>> tests_by_stage(const TraceHeader& header,
                                                                  const TraceFrame& frame);

/// The one of that name, among endings_of.
std::optional<Stage> ending_of(const TraceHeader& header, std::string_view name);

}  // namespace scb
