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

/// Everything that `scb inspect` found.
struct InspectReport {
    TraceHeader header;
    std::string stem;                    ///< that names of files begin with
    std::vector<InspectedFrame> frames;  ///< the one with the most wasted tests first
    Inspection sum;
    std::vector<FalsePair> weak_tests, loose_fits;  ///< the worst ones
    std::vector<WronglyRejectedPair> wrong;         ///< those that miss the most
    std::vector<AlternativeTest> others;
    WasteCauses causes;
    std::optional<SceneTuning> settings;  ///< what would have helped; not of parts of queries
    std::string command;                  ///< that makes the queries with the best of these
    std::string layout_command;           ///< the same packed, where that is measurably quicker
    bool drawn = false;                   ///< there is a picture of each pair
    NamedOptions named;                   ///< what the names of pictures say
    NamedOptions named_frames;            ///< and that of the whole, which frames it is of
    std::string files;                    ///< names of page and tables, without their endings
};

/// Tables of frames end here: more rows make a table that nobody reads.
inline constexpr std::size_t most_frame_rows = 20;

/// The picture of a pair of nodes; empty where none was drawn.
std::string file_of(const InspectReport& report, int frame, const Step& test);

/// So many settings are listed beside that of the queries.
inline constexpr std::size_t most_settings = 8;

/// Which frames the settings were counted in: "frame 150", or `over` and "10 of the 50 frames".
std::string settings_words(const InspectReport& report, const std::string& over);

/// "12 %": the share of a whole, as the tables and pages say it.
std::string share(std::uint64_t part, std::uint64_t whole);

/// As tables for a reader.
std::string inspect_text(const InspectReport& report);

/// Everything, in the paper's language. Beside the header of a trace: `frames`, `sum`, `depths`,
/// `worst`, `worst_rejections`, `alternative_tests`.
nlohmann::ordered_json inspect_json(const InspectReport& report);

}  // namespace scb::app
