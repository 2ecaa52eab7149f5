#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "scb/collide.h"
#include "scb/packed_collide.h"
#include "scb/packed_distance.h"

namespace scb::app {

/// Whether the subjects take turns. Cold: at each frame every subject once. So between two queries
/// of one subject, the others use the caches and the branch predictor, as an application's other
/// work does. Warm: each subject runs through all frames.
enum class BenchOrder { cold, warm };

/// What a timed query found.
struct QueryAnswer {
    Collision found;  ///< of QueryKind::distance, the counts
    /// Of QueryKind::distance, the distance; infinity if nothing is within the limit.
    double distance = 0;
};

/// A query of every subject in every frame, timed `repeats` times.
struct QueryTiming {
    std::size_t subjects = 0, frames = 0;
    int repeats = 1;
    BenchOrder order = BenchOrder::cold;
    bool wall = false;  ///< wall-clock time, for queries that share threads
    std::function<QueryAnswer(std::size_t subject, std::size_t frame)> query;
    /// Called before each query, untimed; may be empty.
    std::function<void(std::size_t subject, std::size_t frame)> before;
    /// Called once with each query's result; may be empty.
    std::function<void(std::size_t subject, std::size_t frame, const QueryAnswer& answer)> keep;
    /// Called after each query; ends the measurement by returning false.
    std::function<bool()> step;
};

/// The result of a packed query as a Collision.
Collision collision_of(PackedCollision found);
Collision collision_of(const PackedTouch& found);
Collision collision_of(PackedWithin found);
/// The same of a distance.
Distance distance_of(const PackedDistance& found);

/// The time of every query in milliseconds (processor time, or wall-clock time with `wall`), per
/// subject and frame: the median of the repeats. None if `step` ended it.
std::optional<std::vector<std::vector<double>>> time_queries(const QueryTiming& timing);

}  // namespace scb::app
