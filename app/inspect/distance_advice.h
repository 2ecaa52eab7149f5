#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/interrupt.h"
#include "app/inspect/inspect_options.h"
#include "app/report/table.h"
#include "app/study/distance_trial.h"
#include "app/study/frame_findings.h"
#include "app/study/query_source.h"

namespace scb::app {

/// The settings that would have helped in inspected queries of distances.
struct DistanceAdvice {
    DistanceTrial trial;
    std::string command;  ///< counts the tests of the best setting
    std::string timing;   ///< times the present and the best volumes
};

/// Tries other settings at the poses of the queries, in the inspected frames, or in evenly spread
/// ones if all would take more than seconds. None if interrupted. `findings`: of all inspected
/// frames.
std::optional<DistanceAdvice> distance_advice(const InspectOptions& options,
                                              const QuerySource& source,
                                              const FrameFindings& findings, const Console& console,
                                              const InterruptWatch& watch);

/// The best setting in a sentence, with its share of the present cost. `frames`: the number of
/// inspected frames.
std::string advice_sentence(const DistanceAdvice& advice, std::size_t frames);

/// Limit of the settings in tables, besides the present one.
inline constexpr std::size_t most_trial_rows = 10;

/// The present setting and the best ones, at most `most` of these. Sums over the frames.
Table trial_table(const DistanceAdvice& advice, std::size_t most);

nlohmann::ordered_json advice_json(const DistanceAdvice& advice);

}  // namespace scb::app
