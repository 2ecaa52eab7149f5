#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/timing/tune_run.h"
#include "render/figures/tune_figure.h"

namespace scb::app {

/// `count` as a multiple of `base`; 1 where that is 0.
double multiple_of(std::uint64_t count, std::uint64_t base);

/// The options that ask for the setting, but for those that are as by default: " --volume scb2
/// --split cost".
std::string setting_options(const TuneSetting& setting);

/// "scb2, split cost, descent area": what of it means anything to the volume.
std::string setting_text(const TuneSetting& setting);

/// The base, then at most so many of the best, one line each; then what is best, in sentences.
std::string tune_rows_text(const SceneTuning& tuning, std::size_t most);

/// As a table for a reader.
std::string tune_table(const SceneTuning& tuning);

nlohmann::ordered_json tune_json(const SceneTuning& tuning);

/// A line per setting.
std::string tune_csv(const SceneTuning& tuning);

/// The base and the best, without footnote and theme.
render::TuneFigure tune_figure(const SceneTuning& tuning);

}  // namespace scb::app
