#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/enum_names.h"
#include "golden/compare/counts_difference.h"
#include "golden/compare/id_difference.h"
#include "golden/compare/image_difference.h"

namespace scb::golden {

/// The result of the comparison of a case with its baseline.
enum class Verdict {
    same,
    different,         ///< counts, ids or colors
    size_differs,      ///< the pictures cannot be compared pixel by pixel
    missing_baseline,  ///< there is none; the candidate is kept to look at
    new_output,        ///< it makes an output that the baseline does not have
    could_not_run,     ///< it failed, or a file of the baseline cannot be read
    skipped,           ///< its meshes are not here
};

inline constexpr EnumNames<Verdict, 7> verdict_names = {
    "same",       "different",     "size differs", "missing baseline",
    "new output", "could not run", "skipped"};

/// Whether a run with such a case fails: all verdicts except same and skipped.
constexpr bool is_failure(Verdict verdict) {
    return verdict != Verdict::same && verdict != Verdict::skipped;
}

/// A picture of a case in three versions, as paths of files relative to the folder of results.json;
/// empty: none.
struct ResultPictures {
    std::string baseline, candidate, difference;

    friend bool operator==(const ResultPictures&, const ResultPictures&) = default;
};

/// The key in `counts` for volume tests by the depth of the pair, which baselines do not have.
inline constexpr std::string_view tests_by_depth_key = "n_v at depth";
bool is_of_trace(const CountChange& change);

/// The result of one case.
struct CaseResult {
    std::string name;
    Verdict verdict = Verdict::same;
    std::string cause;                ///< why it may differ, in sentences, see Cause; empty:
                                      ///< unknown
    std::string message;              ///< what differs, or why it could not run, in a sentence
    std::vector<std::string> lines;   ///< the changes in the terms of the field, a sentence each
    std::vector<CountChange> counts;  ///< counts of the baseline, then counts that only traces have
    std::optional<IdDifference> ids;  ///< if ids were compared and differ
    std::vector<std::string> owners;  ///< "node 412 of A, level 7", ... of the ids' changes
    std::optional<ImageDifference> colors;  ///< if colors were compared and differ; if the verdict
                                            ///< is same: within the tolerance
    /// The box to look at: about the pixels of the scene with other colors, or, if only text and
    /// panels beside it have other colors, about these.
    PixelBox focus;
    ColorTolerance tolerance;
    int variant = 0;  ///< the accepted picture that it was compared with: the first is 1; 0: none
    ResultPictures picture, id_picture;
    std::string reproduce;            ///< a command
    std::string update;               ///< a command
    std::vector<std::string> traces;  ///< kept ones: of the baseline and of the run
    std::string trace_difference;     ///< the difference of the traces, as lines of text
    std::string diff;                 ///< a command, which compares the kept traces
    /// A page of `scb view` with the kept traces, beside results.json, and the place of their first
    /// difference, which the page shows. Without a page only the place: "#frame=50&nodes=5,7".
    std::string view;
    double seconds = 0;

    friend bool operator==(const CaseResult&, const CaseResult&) = default;
};

/// Its most important words, on one line: the cause, then the message.
std::string first_words(const CaseResult& result);

/// Whether its colors differ, but only within the tolerance of the case.
bool is_tolerated(const CaseResult& result);

/// The files that it names: pictures, traces and a page, beside results.json.
std::vector<std::string> files_of(const CaseResult& result);

/// The result of a suite, or of a shard of it.
struct SuiteResult {
    std::string suite;  ///< path of the file with the cases
    std::vector<std::pair<std::string, std::string>> environment;  ///< versions: name and value
    std::vector<CaseResult> cases;                                 ///< in the order of the suite
    std::string shard;                                             ///< "2/3"; empty: all
    std::string incomplete;  ///< the missing part of the run, in a sentence; empty: nothing

    friend bool operator==(const SuiteResult&, const SuiteResult&) = default;
};

/// Whether a case failed, or the run is incomplete.
bool has_failed(const SuiteResult& result);

/// The result as JSON, from which result_of makes an equal one. It has every field, null if there
/// is no value; a box is [left, top, right, bottom], and `beyond` ends with its last entry that is
/// not 0. Texts that are not UTF-8 stay as they are: dump it with
/// nlohmann::json::error_handler_t::replace.
nlohmann::ordered_json result_json(const SuiteResult& result);

/// The result from such JSON. Throws InputError, naming `path` and the place in it, if a field is
/// missing, unknown, of another type or out of range.
SuiteResult result_of(const nlohmann::json& json, const std::string& path);

}  // namespace scb::golden
