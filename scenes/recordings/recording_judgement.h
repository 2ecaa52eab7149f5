#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/judge/query_check.h"
#include "core/judge/tree_watch.h"
#include "scenes/recordings/recorded_queries.h"

namespace scb::scenes {

/// A query of a recording.
struct QueryName {
    int frame = 0;
    std::string a, b;  ///< bodies
};

/// The tests that ended at one stage.
struct StageJudgement {
    std::string name;  ///< "overlap" of stage 0
    std::uint64_t tests = 0;
    std::uint64_t false_positives = 0;       ///< of stage 0
    std::uint64_t wrong = 0;                 ///< of the others
    double least_depth = 0, most_depth = 0;  ///< of the wrong ones, at least
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

/// A query whose tests fit another pose.
struct PoseProblem {
    QueryName query;
    std::string pose;    ///< whose pose they fit: "the pose of the frame before"
    PoseFit told, fits;  ///< errors with the pose that was told, and with the other
    /// Its tests of volumes fit the other pose, and those of triangles the one that was told.
    bool only_volumes = false;
};

struct FrameJudgement {
    int frame = 0;
    std::uint64_t queries = 0, volume_tests = 0, item_tests = 0, wasted = 0, wrong = 0, missed = 0,
                  false_pairs = 0, pairs = 0;
};

/// The problems of a tree.
struct TreeJudgement {
    std::uint32_t number = 0;
    std::string name;
    std::size_t nodes = 0;
    std::uint32_t depth = 0;
    bool unfinished = false;  ///< the file breaks off in it: what it was before that was judged
    std::vector<WatchedProblem> problems;
};

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
    std::vector<std::string> odd;    ///< sentences without a full stop
    std::vector<std::string> notes;  ///< what is not wrong, but may be meant otherwise: the same
    std::size_t more_odd = 0;
    std::string damage;
    std::uint64_t wasted_weak = 0, wasted_loose = 0, nanoseconds = 0, grazing = 0, unjudged = 0,
                  self_queries = 0, exact_pairs = 0;
    std::uint64_t not_looked_into = 0;  ///< see QueryJudgement
    std::uint64_t ended_early = 0;      ///< queries, of which nothing is said to be missed
    /// Queries of two bodies of whose items too little is known, see has_known_items.
    std::uint64_t unknown_items = 0;

    /// Whether something is wrong, and not just slow.
    bool wrong() const;
};

/// Judges all frames, or those that `wanted` says. `done` is told of each, and ends the work where
/// it returns false. Throws InputError as RecordedQueries does.
RecordingJudgement judge_recording(std::string_view bytes, std::string_view name,
                                   const std::function<bool(int frame)>& wanted,
                                   const std::function<bool()>& done);

}  // namespace scb::scenes
