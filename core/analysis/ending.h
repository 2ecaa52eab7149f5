#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/analysis/trace.h"

namespace scb {

/// Tests per ending, indexed by Outcome.
using EndingCounts = std::array<std::uint64_t, ending_count>;

/// How the tests of a frame ended, by the depth of the pair: the depths of both nodes added.
std::vector<EndingCounts> endings_by_depth(const TraceFrame& frame, const TraversalTree& tree);

/// The same for all depths together.
EndingCounts ending_counts(const TraceFrame& frame, const TraversalTree& tree);

/// The endings that queries of these volumes and options can have, in order: the stages of the
/// test, then the others. `triangles` where triangles were tested, else `found`.
std::vector<Outcome> endings_of(VolumeKind kind, const CollideOptions& options);

}  // namespace scb
