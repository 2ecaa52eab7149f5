#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/analysis/trace.h"
#include "scb/stage.h"

namespace scb {

/// How a path of a traversal came to its end: what became of a pair of nodes that was not divided.
/// Values below stage_count are the stages at which two volumes were rejected.
enum class Ending : std::uint8_t {
    triangles_apart = stage_count,  ///< two leaves that overlap, whose triangles do not intersect
    triangles_meet,                 ///< two leaves that overlap, whose triangles intersect
    found,                          ///< nodes that overlap at the level where the query stopped
    left_over,                      ///< they overlap, but the query had its pairs before
};
inline constexpr std::size_t ending_count = stage_count + 4;

constexpr Ending rejected_at(Stage stage) { return static_cast<Ending>(stage); }
constexpr bool is_rejection(Ending ending) {
    return static_cast<std::size_t>(ending) < stage_count;
}

/// Tests per ending, indexed by Ending.
using EndingCounts = std::array<std::uint64_t, ending_count>;

/// "slab-cylinder", ... of rejections; "triangles apart", "triangles meet", "found", "left over".
std::string_view ending_name(Ending ending);
std::optional<Ending> ending_of(std::string_view name);

/// How the test ended its path; nothing where the traversal went on.
std::optional<Ending> ending_of(const VolumeTest& test, Outcome outcome);

/// How the tests of a frame ended, by the depth of the pair: the depths of both nodes added.
std::vector<EndingCounts> endings_by_depth(const TraceFrame& frame, const TestTree& tree);

/// The same for all depths together.
EndingCounts ending_counts(const TraceFrame& frame, const TestTree& tree);

/// The endings that queries of these volumes and options can have, in order: the stages of the
/// test, then the others. `triangles` where triangles were tested, else `found`.
std::vector<Ending> endings_of(VolumeKind kind, const CollideOptions& options);

}  // namespace scb
