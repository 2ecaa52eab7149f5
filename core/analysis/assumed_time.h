#pragma once

#include <cstdint>
#include <optional>

#include "core/analysis/pass_counts.h"
#include "core/analysis/trace.h"
#include "core/analysis/wasted_cost.h"
#include "scb/any_hierarchy.h"
#include "scb/collide.h"
#include "scb/packed_layout.h"

namespace scb {

/// The assumed time of a query, in picoseconds, by equation 1 of the paper: T = N_v C_v + N_p C_p,
/// where C_v includes the cost of moving volumes, and depends on the bound at which a test ends;
/// and a cost for each pair that is found. A descent by area or volume also measures both nodes of
/// each division. Each cost is a constant, so the time is the same on every machine: it compares
/// settings, and predicts no clock.
///
/// The constants are least-squares fits of the relative error over 27 scenes, of smooth meshes, of
/// CAD and of parts that lie on each other, on one core of an Intel Xeon at 2.3 GHz with AVX-512
/// (GCC 12.2, -O3). The constants of a volume's ends are drawn to one constant, and are at least a
/// third of it, since the counts of these ends grow together. All are scaled by one factor to an
/// idle machine. In 23 of the 27 scenes, the volume that they prefer is the quickest; in the others
/// it takes up to 1.21 of the least time. Nine of ten queries take 0.8 to 1.4 of the assumed time.
/// Where parts lie on each other, queries take up to 2.6 of it, since triangles are then decided
/// exactly.
std::uint64_t assumed_time(VolumeKind volume, const OverlapOptions& overlap, DescentRule descent,
                           const Collision& found);

/// The assumed time of one test of two volumes, in picoseconds.
std::uint64_t assumed_test_time(VolumeKind volume, OverlapTest test);

/// The least assumed time of a test, of any end.
std::uint64_t least_test_time(VolumeKind volume, OverlapTest test);

/// The assumed time of one test of two triangles, in picoseconds.
inline constexpr std::uint64_t assumed_triangle_time = 45'000;

/// The assumed time of queries of distances, in picoseconds: N_v C_v + N_p C_p, and a constant for
/// each packed query. It is the same on every machine: it compares settings, and predicts no clock.
/// `layout`: none for unpacked queries.
///
/// The constants are least-squares fits of the relative error over seven scenes, of smooth meshes
/// and of CAD, whose bodies are apart. Unpacked queries take 0.9 to 1.2 of the assumed time there,
/// packed ones 0.8 to 1.5. Where most surfaces are about as near, packed queries take up to 4 times
/// the assumed time: N_p leaves out the pairs of triangles that vector lanes decide.
std::uint64_t assumed_distance_time(VolumeKind volume, const std::optional<PackedLayout>& layout,
                                    std::uint64_t queries, std::uint64_t n_v, std::uint64_t n_p);

/// The assumed costs of the tests of these queries, of any kind. Nothing is known of the time of
/// another engine's tests, so its volumes cost as much as boxes.
TestCosts assumed_costs(const TraceHeader& header);

/// The work of a query of a whole hierarchy, with its assumed time.
Work work_of(VolumeKind volume, const OverlapOptions& overlap, DescentRule descent,
             const Collision& found);

}  // namespace scb
