#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/timing/tune_run.h"
#include "render/figures/tune_figure.h"

namespace scb::app {

/// One row per setting, in groups by what was changed, with means per frame and their ratio to the
/// base's; below, the best settings.
std::string tune_table(const SceneTuning& tuning);

/// The same as JSON; times only where they were measured.
nlohmann::ordered_json tune_json(const SceneTuning& tuning);

/// Lines "tuned,test,threshold,descent,growth,n_v,n_p,operations,pairs,ms" with a header; what
/// means nothing to the volume or the test is empty, ms where nothing was timed.
std::string tune_csv(const SceneTuning& tuning);

render::TuneFigure tune_figure(const SceneTuning& tuning);

}  // namespace scb::app
