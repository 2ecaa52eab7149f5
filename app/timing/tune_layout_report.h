#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/study/tune_run.h"

namespace scb::app {

/// "scb2, split cost, quantized8": the hierarchies and their layout.
std::string layout_text(const SceneTuning& tuning, const TuneLayout& layout);

/// The layout or, if no layout costs less, the setting to use: "scb2, split cost, quantized8,
/// packed".
std::string recommended_text(const SceneTuning& tuning);

/// The options of `scb collide` and `scb bench`: " --volume scb2 --split cost --layout quantized8".
std::string layout_options(const SceneTuning& tuning, const TuneLayout& layout);

/// The call of the library that builds such a packed hierarchy of `mesh`. Split and growth are in
/// `setting`, all else in `build`.
std::string packed_code(const BuildOptions& build, const TuneSetting& setting,
                        const PackedLayout& layout);
/// The same of an unpacked hierarchy.
std::string hierarchy_code(const BuildOptions& build, const TuneSetting& setting);

/// The call of the library that builds such a hierarchy of `mesh`.
std::string layout_code(const SceneTuning& tuning, const TuneLayout& layout);

/// The calls of the library that build such an unpacked hierarchy of `mesh` and, if the overlap
/// test or the descent are others than the default, make a query.
std::string setting_code(const SceneTuning& tuning, const TuneSetting& setting);

/// How to make the best queries: `command`, `layout_command` (empty if no layout is quicker), and
/// the call of the library.
std::string use_text(const SceneTuning& tuning, const std::string& command,
                     const std::string& layout_command);

/// A sentence on the gain of layouts; empty if none were timed.
std::string layout_sentence(const SceneTuning& tuning);

/// At most `most` layouts of each packed setting, the quickest first; without times all, in their
/// order. Empty if there are none.
std::string layout_rows_text(const SceneTuning& tuning, std::size_t most);

nlohmann::ordered_json layouts_json(const SceneTuning& tuning);

}  // namespace scb::app
