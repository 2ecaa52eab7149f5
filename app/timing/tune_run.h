#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/query/scene_query.h"
#include "core/analysis/tuning.h"

namespace scb::app {

/// What one setting took: means per frame.
struct TuneRow {
    TuneTrial trial;
    double n_v = 0, n_p = 0;
    double operations = 0;  ///< of the volume tests, see operation_count
    double pairs = 0;
    bool misses_pairs = false;  ///< has fewer in some frame than another setting has
    double ms = 0;              ///< processor time of a query; NaN where nothing was timed
};

/// The settings of one scene, the base first.
struct SceneTuning {
    std::string scene;
    std::vector<std::string> bodies;     ///< names of A and B
    std::vector<std::size_t> triangles;  ///< of A and B
    std::vector<int> frames;
    VolumeKind kind{};
    BuildOptions build;  ///< but for the growth
    std::vector<TuneRow> rows;
    bool timed = false;
    std::size_t fewest_operations = 0, least_time = 0;  ///< rows; the latter where timed
};

struct TuneOptions {
    TuneSetting base;  ///< overlap and growth as by default where they mean nothing to the kind
    VolumeKind kind{};
    BuildOptions build;  ///< but for the growth, which is tuned
    int repeats = 0;     ///< of each timed query; 0: nothing is timed
};

/// Told of a part of the run that begins, with how many steps it has; then of each step, by
/// `step`, which ends the run by returning false.
struct TuneProgress {
    std::function<void(std::string_view what, std::size_t steps)> begin;
    std::function<bool()> step;
};

/// A setting must be that much quicker than the base to be called better: that much times differ
/// from run to run.
inline constexpr double least_time_gain = 0.02;

/// Counts what tune_trials take, picks the best of each (by operations, and by time where that is
/// another one; for that each is timed once) and then times all, so that all take turns at each
/// frame. Nothing where it was ended.
std::optional<SceneTuning> tune_scene(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                      const std::vector<int>& frames, const TuneOptions& options,
                                      const TuneProgress& progress);

}  // namespace scb::app
