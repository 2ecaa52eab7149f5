#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/judge/query_check.h"
#include "core/judge/tree_fit.h"
#include "core/judge/tree_watch.h"
#include "scenes/recordings/pose_search.h"
#include "scenes/recordings/recorded_queries.h"

namespace scb::scenes {

/// The tests that ended at one stage.
struct StageJudgement {
    std::string name;  ///< "overlap" for stage 0
    std::uint64_t tests = 0;
    std::uint64_t false_positives = 0;       ///< only at stage 0
    std::uint64_t wrong = 0;                 ///< only at other stages
    double least_depth = 0, most_depth = 0;  ///< of the wrong tests, lower bounds
    double most_apart = 0;                   ///< of the false positives
    std::string farthest;  ///< the false positive that is farthest apart, a clause
};

/// One case of a problem.
struct ProblemCase {
    QueryName query;
    std::string words;  ///< a clause: which pair, at which nodes and test
    IndexPair nodes{no_index, no_index}, items{no_index, no_index};  ///< numbers
    /// The number of the test of volumes in its query, from 0. For a test of triangles, the number
    /// of the test of volumes before it.
    std::uint32_t test = no_index;
    bool has_volumes = false;  ///< both nodes exist and have volumes, as `scb explain` needs
};

/// The cases of a problem with one cause.
struct ProblemGroup {
    static constexpr std::size_t most_cases = 100;

    std::string what;  ///< "rejected although the volumes overlap"
    std::uint64_t count = 0;
    std::vector<ProblemCase> cases;  ///< the first ones
};

/// A part of a recording that could not be judged.
struct NotJudged {
    std::uint64_t count = 0, of = 0;  ///< how many, of how many there are
    std::string what;                 ///< "tests of volumes"
    std::string why;                  ///< a clause
};

/// Why queries take more tests than they need. This is no error.
struct CostFinding {
    enum class Kind {
        repeated,  ///< `count` of `of` tests repeat an earlier test of their query
        deep,      ///< the tree has depth `count`; `of` would be enough
        loose,     ///< `count` of `of` boxes are much larger than what is below them
    };
    Kind kind = Kind::repeated;
    std::uint64_t count = 0, of = 0;
    std::string where;  ///< the tree; for repeated tests, the first of them
    /// For loose boxes: the tests of volumes of all queries, and their number with boxes that fit.
    std::uint64_t tests = 0, tests_if_tight = 0;
};

/// How precisely a frame can be judged.
struct FrameTolerance {
    double volumes = 0, triangles = 0;  ///< the largest lengths, see EngineQuery::tolerance
    double away = 0;                    ///< the largest, see EngineQuery::away
    bool single = false;                ///< 32-bit numbers
    std::string hides;  ///< whose triangles or leaves are not larger, a clause; empty: none
};

struct FrameJudgement {
    int frame = 0;
    FrameTolerance tolerance;
    std::uint64_t queries = 0, volume_tests = 0, item_tests = 0, wasted = 0, wrong = 0, missed = 0,
                  false_pairs = 0, pairs = 0;
    std::vector<std::string>
        log{};  ///< the first lines of the engine's log, if a test or pair is wrong
    std::uint64_t log_lines = 0;  ///< how many lines there are
};

/// The problems of a tree.
struct TreeJudgement {
    std::uint32_t number = 0;
    std::string name;
    std::size_t nodes = 0;
    std::uint32_t depth = 0;
    std::size_t roots = 0;
    std::uint64_t in_several_leaves = 0;  ///< the largest number of triangles in any frame
    bool unfinished = false;  ///< the file breaks off in this tree; its earlier state was judged
    std::vector<WatchedProblem> problems;
    std::optional<TreeFit> fit;  ///< a change of the mesh that explains most `outside` problems
    int fit_at = 0;              ///< frame
};

/// In order: all was judged, and nothing is wrong; some parts could not be judged, and nothing is
/// wrong in the others; something is proven wrong.
enum class Verdict { valid, partly_judged, wrong };

/// The judgement of a recording: whether its trees are valid and contain their triangles, whether
/// its tests are right for the recorded volumes, and whether its results equal this project's
/// results.
struct RecordingJudgement {
    std::string engine;
    RecordingSummary summary;
    std::vector<TreeJudgement> trees;
    std::vector<FrameJudgement> frames;
    std::vector<StageJudgement> stages;             ///< stages that occur, or were named
    std::vector<ProblemGroup> missed, false_pairs;  ///< by cause; the most frequent first
    std::vector<ProblemGroup> answers;              ///< wrong answers of distance queries, likewise
    std::uint64_t distances = 0;                    ///< answers of distance queries
    std::vector<ProblemGroup> test_problems;        ///< of tests, by what is wrong
    std::vector<PoseProblem> poses;
    std::vector<std::string> stretches;  ///< bodies whose poses scale or mirror them: clauses
    OddRecords odd;                      ///< records that contradict the trees
    OddRecords unusable;                 ///< records that cannot be used
    std::vector<std::string> notes;      ///< clauses: not wrong, but perhaps not intended
    std::string damage;
    std::vector<NotJudged> not_judged;
    std::vector<CostFinding> costs;
    WastedTests wasted;
    std::uint64_t nanoseconds = 0, grazing = 0, exact_pairs = 0;
    std::uint64_t not_looked_into = 0;  ///< see QueryJudgement
    std::uint64_t unjudged = 0;         ///< tests of volumes that could not be judged
    std::uint64_t ended_early = 0;      ///< queries, whose missed pairs are not reported
    std::uint64_t frames_left = 0;      ///< frames left unjudged by an interruption
    /// Queries without known items, see has_known_items.
    std::uint64_t unknown_items = 0;

    /// The sum of a count over the frames.
    std::uint64_t total(std::uint64_t FrameJudgement::*count) const;
    /// The verdict. Slow queries are not wrong.
    Verdict verdict() const;
    bool wrong() const { return verdict() == Verdict::wrong; }
};

/// Receives each judged query: the recording at the query, and its judgement.
using JudgedQueryVisitor = std::function<void(const RecordedQueries&, const QueryJudgement&)>;

/// Judges the frames that `wanted` accepts, and hands each judged query to `visit`. `done` is
/// called with true after each frame; with false after each query, and from time to time during
/// one. It ends the work by returning false. Throws InputError as RecordedQueries does.
RecordingJudgement judge_recording(const RecordingFile& file,
                                   const std::function<bool(int frame)>& wanted,
                                   const std::function<bool(bool frame)>& done,
                                   const JudgedQueryVisitor& visit = {});

}  // namespace scb::scenes
