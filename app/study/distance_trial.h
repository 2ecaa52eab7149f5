#pragma once

#include <optional>
#include <vector>

#include "app/study/distance_setting.h"
#include "app/study/scene_query.h"
#include "app/study/tune_run.h"

namespace scb::app {

/// The work of one setting in all frames of a trial; of Work, operations are not counted.
struct DistanceRow {
    DistanceSetting setting;
    Work work;
};

/// The same queries of distances by several settings.
struct DistanceTrial {
    std::vector<int> frames;
    std::vector<DistanceRow> rows;  ///< the present setting first, then by cost, the least first
    std::size_t tried = 0;          ///< settings, given up or not
    bool is_within = false;         ///< of queries within a tolerance, which have no order

    /// The row of the least cost; the present one if no other costs less.
    const DistanceRow& best() const;
};

/// Repeats the queries with other volumes; of the cheapest ones with other orders, from the closest
/// triangles of the frame before, and packed. A setting is given up as soon as it costs over
/// `hopeless_cost` times the least before it. None if `progress` ended it. `query` must be of
/// distances, and not packed.
std::optional<DistanceTrial> try_distances(const SceneQuery& query, const std::vector<int>& frames,
                                           const TuneProgress& progress);

}  // namespace scb::app
