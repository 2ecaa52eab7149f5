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
    std::string name;  ///< "overlap" of stage 0
    std::uint64_t tests = 0;
    std::uint64_t false_positives = 0;       ///< of stage 0
    std::uint64_t wrong = 0;                 ///< of the others
    double least_depth = 0, most_depth = 0;  ///< of the wrong ones, at least
    double most_apart = 0;                   ///< of the false positives
    std::string farthest;                    ///< which that is, a clause
};

/// Something that went wrong.
struct ProblemCase {
    QueryName query;
    std::string words;  ///< a clause: which pair, at which nodes and test
    IndexPair nodes{no_index, no_index}, items{no_index, no_index};  ///< numbers
    /// The number of the test of volumes, among those of its query, from 0; of a test of triangles
    /// that of the test before it.
    std::uint32_t test = no_index;
};

/// What went wrong for one reason.
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

/// Why queries take more tests than they need. That is not wrong.
struct CostFinding {
    enum class Kind {
        repeated,  ///< `count` tests of `of` were made before in their query
        deep,      ///< the tree is `count` deep, where `of` would do
        loose,     ///< `count` boxes of `of` are much larger than what is below them
    };
    Kind kind = Kind::repeated;
    std::uint64_t count = 0, of = 0;
    std::string where;  ///< the tree; of repeated tests the first one
    /// Of loose boxes: the tests of volumes of all queries, and how many they would be with boxes
    /// that fit.
    std::uint64_t tests = 0, tests_if_tight = 0;
};

/// How exact an engine's numbers let a frame be judged.
struct FrameTolerance {
    double volumes = 0, triangles = 0;  ///< lengths, see EngineQuery::tolerance: the largest
    double away = 0;                    ///< see EngineQuery::away: the largest
    bool single = false;                ///< numbers of 32 bits
    std::string hides;  ///< whose triangles or leaves are smaller, a clause; empty: none
};

struct FrameJudgement {
    int frame = 0;
    FrameTolerance tolerance;
    std::uint64_t queries = 0, volume_tests = 0, item_tests = 0, wasted = 0, wrong = 0, missed = 0,
                  false_pairs = 0, pairs = 0;
};

/// The problems of a tree.
struct TreeJudgement {
    std::uint32_t number = 0;
    std::string name;
    std::size_t nodes = 0;
    std::uint32_t depth = 0;
    std::size_t roots = 0;
    std::uint64_t in_several_leaves = 0;  ///< triangles: the most of any frame
    bool unfinished = false;  ///< the file breaks off in it: what it was before that was judged
    std::vector<WatchedProblem> problems;
    std::optional<TreeFit> fit;  ///< one change that explains most nodes that do not contain
    int fit_at = 0;              ///< frame
};

/// What was recorded could all be judged and nothing is wrong; nothing is wrong in what could be
/// judged; something is proven wrong.
enum class Verdict { sound, partly_judged, wrong };

/// A recording, judged: whether its trees are trees that contain their triangles, whether its tests
/// are right on its own volumes, and whether its results are those of this project's query.
struct RecordingJudgement {
    std::string engine;
    RecordingSummary summary;
    std::vector<TreeJudgement> trees;
    std::vector<FrameJudgement> frames;
    std::vector<StageJudgement> stages;             ///< those that occur, or were named
    std::vector<ProblemGroup> missed, false_pairs;  ///< by cause; the most frequent first
    std::vector<ProblemGroup> test_problems;        ///< of tests, by what is wrong
    std::vector<PoseProblem> poses;
    std::vector<std::string> stretches;  ///< bodies whose poses scale or mirror them: clauses
    OddRecords odd;                      ///< they contradict the trees
    OddRecords unusable;                 ///< they say nothing that could be judged
    std::vector<std::string> notes;  ///< what is not wrong, but may be meant otherwise: the same
    std::string damage;
    std::vector<NotJudged> not_judged;
    std::vector<CostFinding> costs;
    std::uint64_t wasted_weak = 0, wasted_loose = 0, nanoseconds = 0, grazing = 0, exact_pairs = 0;
    std::uint64_t not_looked_into = 0;  ///< see QueryJudgement
    std::uint64_t unjudged = 0;         ///< tests of volumes of nodes without one that is known
    std::uint64_t ended_early = 0;      ///< queries, of which nothing is said to be missed
    std::uint64_t frames_left = 0;      ///< of a judgement that was interrupted
    /// Queries of whose items too little is known, see has_known_items.
    std::uint64_t unknown_items = 0;

    /// The sum of a count over the frames.
    std::uint64_t total(std::uint64_t FrameJudgement::*count) const;
    /// Something that is slow is not wrong.
    Verdict verdict() const;
    bool wrong() const { return verdict() == Verdict::wrong; }
};

/// Judges all frames, or those that `wanted` says. `done` is called after each query and each
/// frame, with whether a frame is done, and ends the work where it returns false. Throws InputError
/// as RecordedQueries does.
RecordingJudgement judge_recording(const RecordingFile& file,
                                   const std::function<bool(int frame)>& wanted,
                                   const std::function<bool(bool frame)>& done);

}  // namespace scb::scenes
