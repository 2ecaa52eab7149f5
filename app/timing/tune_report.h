#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

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

/// "0.0123 [0.0120, 0.0131]"; of one run the time alone.
std::string interval_text(const SceneTuning& tuning, const TimeInterval& ms);

/// Which setting is recommended and why; then which ones cost least and have the fewest volume
/// tests, where these are others. `base` is what the base is called: "the base".
std::vector<std::string> best_sentences(const SceneTuning& tuning, const std::string& base);

/// The base, then at most so many of the best, one line each; then what is best, in sentences.
std::string tune_rows_text(const SceneTuning& tuning, std::size_t most, const std::string& base);

/// As a table for a reader.
std::string tune_table(const SceneTuning& tuning);

nlohmann::ordered_json tune_json(const SceneTuning& tuning);

/// A line per setting.
std::string tune_csv(const SceneTuning& tuning);

/// The base and the best, without footnote and theme.
render::TuneFigure tune_figure(const SceneTuning& tuning);

}  // namespace scb::app
