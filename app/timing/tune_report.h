#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/study/tune_run.h"
#include "render/figures/tune_figure.h"

namespace scb::app {

/// `count` as a multiple of `base`; 1 if `base` is 0.
double multiple_of(std::uint64_t count, std::uint64_t base);

/// The options of the setting that differ from the default: " --volume scb2 --split cost".
std::string setting_options(const TuneSetting& setting);

/// "scb2, split cost, descent area": the options that matter to the volume.
std::string setting_text(const TuneSetting& setting);

/// "0.0123 [0.0120, 0.0131]"; for one run only the time.
std::string interval_text(const SceneTuning& tuning, const TimeInterval& ms);

/// The recommended setting and the reason; then the settings with the least cost and with the
/// fewest volume tests, if they are others. `base`: the name of the base, "the base".
std::vector<std::string> best_sentences(const SceneTuning& tuning, const std::string& base);

/// The base, then at most `most` of the best settings, one line each; then sentences on the best.
std::string tune_rows_text(const SceneTuning& tuning, std::size_t most, const std::string& base);

/// A table for a reader.
std::string tune_table(const SceneTuning& tuning);

nlohmann::ordered_json tune_json(const SceneTuning& tuning);

/// A line per setting.
std::string tune_csv(const SceneTuning& tuning);

/// The base and the best settings, without footnote and theme.
render::TuneFigure tune_figure(const SceneTuning& tuning);

}  // namespace scb::app
