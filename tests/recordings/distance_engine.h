#pragma once

#include <string>

namespace scb {

/// What is wrong with the small engine of distances, on purpose.
enum class DistanceBug {
    none,
    wrong_radius,     ///< the bound of two balls subtracts A's radius twice
    stale_node,       ///< a ball is not refitted in one frame
    squared_bound,    ///< the square of a bound is compared with the distance
    early_stop,       ///< the last pair of nodes on the stack is left there
    wrong_units,      ///< the answer is in thousandths of the unit
    swapped_bodies,   ///< the triangles of A and B are exchanged
    wrong_point,      ///< the closest point of B is a corner of its triangle
    tolerance_twice,  ///< pairs are looked for within twice the tolerance
    nan_bound,        ///< the bound of balls that overlap is not a number
    old_seed,         ///< the search begins with the distance of the frame before
};
inline constexpr const char* distance_bug_names[] = {
    "distance-none",           "distance-wrong-radius", "distance-stale-node",
    "distance-squared-bound",  "distance-early-stop",   "distance-wrong-units",
    "distance-swapped-bodies", "distance-wrong-point",  "distance-tolerance-twice",
    "distance-nan-bound",      "distance-old-seed"};
inline constexpr int distance_bug_count = 11;

/// An engine of some 100 lines, with hierarchies of balls, measures the distance of two waving
/// sheets in four frames, looks for all triangles within a tolerance, and records both queries.
void record_distance_engine(DistanceBug bug, const std::string& path);

}  // namespace scb
