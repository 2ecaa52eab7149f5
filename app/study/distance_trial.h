#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/scene_query.h"
#include "app/study/tune_run.h"
#include "core/analysis/wasted_cost.h"

namespace scb::app {

/// How queries of distances are made.
struct DistanceMethod {
    VolumeKind volume = VolumeKind::scb2;
    SplitMethod split = SplitMethod::cost;
    DistanceOrder order = DistanceOptions{}.order;
    bool seeded = false;  ///< begins with the closest triangles of the frame before
    std::optional<PackedLayout> layout{};
};

/// The work of one method in all frames of a trial; of Work, operations are not counted.
struct DistanceRow {
    DistanceMethod method;
    Work work;
};

/// The same queries of distances by several methods.
struct DistanceTrial {
    std::vector<int> frames;
    std::vector<DistanceRow> rows;  ///< the present method first, then by cost, the least first
    std::size_t tried = 0;          ///< methods, with those that were given up
    bool is_within = false;         ///< of queries within a tolerance, which have no order

    /// The row of the least cost; the present one if no other costs less.
    const DistanceRow& best() const;
};

/// The assumed time of queries of distances, in picoseconds: N_v C_v + N_p C_p, and a constant for
/// each packed query. It is the same on every machine: it compares methods, and predicts no clock.
///
/// The constants are least-squares fits of the relative error over seven scenes, of smooth meshes
/// and of CAD, whose bodies are apart. Unpacked queries take 0.9 to 1.2 of the assumed time there,
/// packed ones 0.8 to 1.5.
std::uint64_t assumed_distance_time(const DistanceMethod& method, std::uint64_t queries,
                                    std::uint64_t n_v, std::uint64_t n_p);

/// The assumed costs of the tests of these queries, of any kind. Nothing is known of the time of
/// another engine's tests, so its volumes cost as much as boxes.
TestCosts costs_of_tests(const TraceHeader& header);

/// Repeats the queries with other volumes; of the cheapest ones with other orders, from the closest
/// triangles of the frame before, and packed. A method is given up as soon as it costs over
/// `hopeless_cost` times the least before it. None if `progress` ended it. `query` must be of
/// distances, and not packed.
std::optional<DistanceTrial> try_distances(const SceneQuery& query, const std::vector<int>& frames,
                                           const TuneProgress& progress);

}  // namespace scb::app
