#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "scb/collide.h"
#include "scb/packed_collide.h"

namespace scb::app {

/// Whether the subjects take turns. Cold: at each frame every subject once, so that between two
/// queries of one the others pass through the caches and the branch predictor, as an application's
/// other work does. Warm: each subject runs through all frames.
enum class BenchOrder { cold, warm };

/// What is to be timed: a query of every subject in every frame, so many times.
struct QueryTiming {
    std::size_t subjects = 0, frames = 0;
    int repeats = 1;
    BenchOrder order = BenchOrder::cold;
    bool wall = false;  ///< the time that passes, where threads share a query
    std::function<Collision(std::size_t subject, std::size_t frame)> query;
    /// Called before each query, untimed; may be empty.
    std::function<void(std::size_t subject, std::size_t frame)> before;
    /// Told what each query found, once; may be empty.
    std::function<void(std::size_t subject, std::size_t frame, const Collision& found)> keep;
    /// Called after each query; ends the measurement by returning false.
    std::function<bool()> step;
};

/// What a packed query found, as others have it.
Collision collision_of(PackedCollision found);

/// The processor time of every query in milliseconds, or the time that passes, per subject and
/// frame: the median of the repeats. Nothing where it was ended.
std::optional<std::vector<std::vector<double>>> time_queries(const QueryTiming& timing);

}  // namespace scb::app
