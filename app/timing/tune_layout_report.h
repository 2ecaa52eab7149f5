#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/timing/tune_run.h"

namespace scb::app {

/// "scb2, split cost, quantized8": what is packed, and how.
std::string layout_text(const SceneTuning& tuning, const TuneLayout& layout);

/// The options of `scb bench` that ask for it: " --volume scb2 --split cost --layout quantized8".
std::string layout_options(const SceneTuning& tuning, const TuneLayout& layout);

/// What layouts are worth, as a sentence; empty where none were timed.
std::string layout_sentence(const SceneTuning& tuning);

/// At most so many layouts of each setting that was packed, the quickest first, or where nothing is
/// timed all, as they are; empty where there are none.
std::string layout_rows_text(const SceneTuning& tuning, std::size_t most);

nlohmann::ordered_json layouts_json(const SceneTuning& tuning);

}  // namespace scb::app
