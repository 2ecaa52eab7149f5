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
    DistanceTrial trial;  ///< its present setting is the default if the queries were recorded
    std::string command;  ///< counts the tests of the best setting
    std::string timing;   ///< times the present and the best volumes
    /// Of a recording: the engine and its volumes, and its work in the frames of `trial`.
    std::string engine;
    std::optional<Work> recorded;
    bool changes_meshes = false;  ///< of a recording: one frame is compared
};

/// Tries other settings at the poses of the queries, in the inspected frames, or in evenly spread
/// ones if all would take more than seconds. None if interrupted. Throws InputError if a recording
/// cannot be compared, see compared_recording; also if the limits of its queries differ.
/// `findings`: of all inspected frames.
std::optional<DistanceAdvice> distance_advice(const InspectOptions& options,
                                              const QuerySource& source,
                                              const FrameFindings& findings, const Console& console,
                                              const InterruptWatch& watch);

/// The best setting in a sentence, with its share of the present cost.
std::string advice_sentence(const DistanceAdvice& advice);

/// Limit of the settings in tables, besides the present one.
inline constexpr std::size_t most_trial_rows = 10;

/// The present setting, or the recorded work, and the best settings, at most `most` of these. Sums
/// over the frames.
Table trial_table(const DistanceAdvice& advice, std::size_t most);

/// The meaning of the rows and columns.
std::string trial_words(const DistanceAdvice& advice);

nlohmann::ordered_json advice_json(const DistanceAdvice& advice);

}  // namespace scb::app
