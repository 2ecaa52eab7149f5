#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/inspect/distance_advice.h"
#include "app/inspect/inspect_settings.h"
#include "app/pictures/picture_name.h"
#include "core/analysis/alternative_test.h"
#include "core/analysis/inspection.h"
#include "core/analysis/tested_triangles.h"
#include "core/analysis/waste_causes.h"
#include "core/analysis/worst_pairs.h"
#include "scenes/recordings/recording_judgement.h"

namespace scb::app {

/// A picture of a problem in a recording.
struct ProblemPicture {
    std::string what;  ///< the report's text of the problem
    std::string file;
};

/// The judgement of another engine's recording.
struct InspectedRecording {
    std::string path;
    scenes::RecordingJudgement judged;
    std::size_t top = 0;    ///< limit of the listed frames, and of the problems of a tree
    std::size_t cases = 1;  ///< limit of the listed cases of a problem
    std::vector<ProblemPicture> pictures;
};

/// The costliest pairs that passed for one reason.
struct WorstOfReason {
    PassReason reason{};
    std::vector<FalsePair> pairs;  ///< the worst first
};

/// The triangles of a body that take part in the most tests.
struct BodyTriangles {
    std::vector<CostlyTriangle> costly;
    std::uint64_t tests = 0;  ///< triangle tests of all triangles of the body
};

/// All findings of `scb inspect`: the judgement of a recording, and the waste in queries of two
/// bodies, or of one with itself.
struct InspectReport {
    std::optional<InspectedRecording> recording;
    TraceHeader header;
    std::string stem;  ///< the beginning of file names
    /// False: nothing is known about waste, and the members from `others` to `causes` are not set.
    /// A recording may be wrong, have no results, or have queries of several pairs of bodies.
    bool has_waste = true;
    std::vector<InspectedFrame> frames;  ///< the one with the most wasted tests first
    Inspection sum;
    std::vector<WorstOfReason> worst;        ///< by waste_reasons
    std::vector<WronglyRejectedPair> wrong;  ///< the ones that miss the most
    std::array<BodyTriangles, 2> triangles;  ///< of A and B; in a self query all of A
    std::vector<AlternativeTest> others;
    WasteCauses causes;
    /// None for partial queries, and for recordings that cannot be compared.
    std::optional<InspectSettings> settings;
    std::optional<DistanceAdvice> distance_advice;  ///< of queries of distances
    bool drawn = false;                             ///< each pair has a picture
    NamedOptions named;                             ///< options in the names of pictures
    NamedOptions named_frames;  ///< frames in the name of the picture of all frames
    std::string files;          ///< names of page and tables, without their endings
};

/// Limit of the frames in tables.
inline constexpr std::size_t most_frame_rows = 20;
/// Limit of the triangles of a body in tables.
inline constexpr std::size_t most_costly = 10;

/// The file name of a pair's picture; empty if it was not drawn.
std::string file_of(const InspectReport& report, int frame, const Step& test);

/// "12 %": the share of a whole, for tables and pages.
std::string share(std::uint64_t part, std::uint64_t whole);

/// Operations of volume tests in words; a dash for another engine, whose operations are unknown.
std::string operations_text(const InspectReport& report, std::uint64_t operations);

/// The frames that waste the most, at most `most`, and their sum.
std::string inspect_frames_text(const InspectReport& report, std::size_t most);

/// The wrong rejections that miss the most, at most `most`; empty if there are none.
std::string inspect_rejections_text(const InspectReport& report, std::size_t most);

/// For a reader: of a scene, the summary or, if `full`, all tables.
std::string inspect_text(const InspectReport& report, bool full);

/// All findings, in the paper's notation. The waste has `frames`, `sum`, `depths`, `worst`,
/// `worst_rejections` and `other_tests`: besides the header of a trace, or in `waste` besides the
/// judgement of a recording.
nlohmann::ordered_json inspect_json(const InspectReport& report);

}  // namespace scb::app
