#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/picture_name.h"
#include "app/timing/tune_run.h"
#include "core/analysis/alternative_test.h"
#include "core/analysis/inspection.h"
#include "core/analysis/waste_causes.h"
#include "core/analysis/worst_pairs.h"

namespace scb::app {

/// All findings of `scb inspect`.
struct InspectReport {
    TraceHeader header;
    std::string stem;                    ///< the beginning of file names
    std::vector<InspectedFrame> frames;  ///< the one with the most wasted tests first
    Inspection sum;
    std::vector<FalsePair> weak_tests, loose_fits;  ///< the worst ones
    std::vector<WronglyRejectedPair> wrong;         ///< the ones that miss the most
    std::vector<AlternativeTest> others;
    WasteCauses causes;
    std::optional<SceneTuning>
        settings;                ///< settings that would have helped; none for partial queries
    std::string command;         ///< makes the queries with the recommended setting
    std::string layout_command;  ///< the same with a packed layout, if that is measurably quicker
    bool drawn = false;          ///< each pair has a picture
    NamedOptions named;          ///< options in the names of pictures
    NamedOptions named_frames;   ///< frames in the name of the picture of all frames
    std::string files;           ///< names of page and tables, without their endings
};

/// Limit of the frames in tables.
inline constexpr std::size_t most_frame_rows = 20;

/// The file name of a pair's picture; empty if it was not drawn.
std::string file_of(const InspectReport& report, int frame, const Step& test);

/// Limit of the settings listed besides the setting of the queries.
inline constexpr std::size_t most_settings = 8;

/// The frames in which the settings were counted: "frame 150", or `over` and "10 of the 50 frames".
std::string settings_words(const InspectReport& report, const std::string& over);

/// "12 %": the share of a whole, for tables and pages.
std::string share(std::uint64_t part, std::uint64_t whole);

/// Tables for a reader.
std::string inspect_text(const InspectReport& report);

/// All findings, in the paper's notation. Besides the header of a trace: `frames`, `sum`, `depths`,
/// `worst`, `worst_rejections`, `alternative_tests`.
nlohmann::ordered_json inspect_json(const InspectReport& report);

}  // namespace scb::app
