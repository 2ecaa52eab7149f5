#include "scenes/recordings/recording_judgement.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/base/text_format.h"
#include "scenes/recordings/distance_findings.h"
#include "scenes/recordings/judgement_words.h"
#include "scenes/recordings/own_contacts.h"
#include "scenes/recordings/query_costs.h"
#include "scenes/recordings/test_findings.h"
#include "scenes/recordings/tolerance_check.h"

namespace scb::scenes {
namespace {

/// Judges a recording query by query.
class RecordingJudge {
  public:
    RecordingJudge(const RecordingFile& file, const std::function<bool()>& go_on,
                   const JudgedQueryVisitor& visit)
        : recording_(file), trees_(recording_), go_on_(go_on), visit_(visit) {
        result_.summary = file.summary;
    }

    RecordingJudgement judged(const std::function<bool(int)>& wanted,
                              const std::function<bool(bool)>& done) && {
        for (;;) {
            const RecordedQueries::Ended ended = recording_.next();
            if (ended == RecordedQueries::Ended::end) break;
            const bool want = wanted(recording_.frame());
            if (ended == RecordedQueries::Ended::query) {
                if (want) take_query(recording_.query());
                if (want && !done(false)) {
                    note_left(wanted, recording_.frame());
                    break;
                }
                continue;
            }
            if (!want) continue;
            for (const auto& [number, tree] : recording_.trees())
                trees_.look(number, result_.summary.body_names);
            tolerances_.take_trees(recording_, frame().tolerance);
            take_log();
            if (!done(true)) {
                note_left(wanted, recording_.frame() + 1);
                break;
            }
        }
        finish();
        return std::move(result_);
    }

  private:
    /// Counts the frames that are left unjudged, from this one on.
    void note_left(const std::function<bool(int)>& wanted, int from) {
        for (const int frame : result_.summary.frames)
            if (wanted(frame)) ++(frame < from ? frames_judged_ : result_.frames_left);
    }

    /// Keeps the engine's log of the frame if something is wrong in it.
    void take_log() {
        constexpr std::size_t most = 5;
        FrameJudgement& row = frame();
        if (row.wrong + row.missed + row.false_pairs == 0) return;
        const std::vector<std::string>& log = recording_.log();
        row.log.assign(log.begin(),
                       log.begin() + static_cast<std::ptrdiff_t>(std::min(most, log.size())));
        row.log_lines = log.size();
    }

    FrameJudgement& frame() {
        if (result_.frames.empty() || result_.frames.back().frame != recording_.frame())
            result_.frames.emplace_back().frame = recording_.frame();
        return result_.frames.back();
    }

    void take_query(const EngineQuery& query) {
        const auto bodies = recording_.query_bodies();
        for (const std::uint32_t body : bodies)
            trees_.look(recording_.bodies().at(body).tree, result_.summary.body_names);
        const QueryName name{query.frame, name_of(bodies[0]), name_of(bodies[1]),
                             recording_.query_name()};
        FrameJudgement& row = frame();
        ++row.queries;
        ++queries_;
        result_.nanoseconds += query.nanoseconds;
        result_.ended_early += !query.complete;
        if (!query.placed) {
            take_faulty_pose(name);
            return;
        }
        if (!query.is_known) {
            ++unknown_kinds_;
            return;
        }
        note_stretch(bodies);
        const bool known = has_known_items(query);
        result_.unknown_items += !known;
        note_moves(query, name);
        QueryTruth truth = own_.truth(query, recording_.finite_meshes());
        truth.distance_before = distances_.before(bodies, query.frame);
        const QueryJudgement judged = judge_query(query, truth, go_on_);
        if (judged.interrupted) return;
        if (visit_) visit_(recording_, judged);
        tolerances_.take(recording_, query, result_.summary.body_names, row.tolerance);
        tests_.take(recording_, query, judged, name, row);
        row.wasted += judged.wasted.all();
        result_.wasted += judged.wasted;
        result_.grazing += judged.grazing;
        if (query.kind != QueryKind::collide) {
            row.wrong += judged.wrong_bounds.size();
            distances_.take(query, bodies, truth, judged, name, tests_);
            if (query.kind == QueryKind::within) note_twice(query, judged, name);
        }
        take_pairs(query, judged, name, row);
        if (query.kind == QueryKind::collide) costs_.take(recording_, query, judged);
        without_result_ += !query.complete && known && judged.reported == 0;
        unknown_objects_ = std::max(unknown_objects_, judged.unknown_objects);
        objects_ = std::max(objects_, judged.objects);
        if (judged.grazing_missed > 0 && grazing_missed_ == 0)
            first_grazing_ = query_words(name) + ", " +
                             pair_words(query.sides[0].mesh ? "triangles" : "objects",
                                        judged.first_grazing.a, judged.first_grazing.b);
        grazing_missed_ += judged.grazing_missed;
        const bool errs =
            std::any_of(judged.wrong_item_tests.begin(), judged.wrong_item_tests.end(),
                        [](const WrongItemTest& test) { return !test.unknown; });
        // The bounds of distances depend on the answer too, so only measured triangles show a pose.
        const bool rejects =
            query.kind == QueryKind::collide && judged.count(TestVerdict::wrong) > 0;
        if (!query.self && (rejects || errs))
            poses_.take(query, name, recording_.bodies().at(bodies[0]),
                        recording_.bodies().at(bodies[1]));
    }

    std::string name_of(std::uint32_t body) const { return result_.summary.body_names.at(body); }

    void take_faulty_pose(const QueryName& name) {
        for (const std::uint32_t number : recording_.query_bodies()) {
            const BodyState& body = recording_.bodies().at(number);
            if (body.pose_fault.empty()) continue;
            if (!body.is_finite) {
                tests_.add("a query's pose is not finite", {name, "it is not judged"});
            } else if (unplaced_++ == 0) {
                unplaced_why_ = "the pose of " + name_of(number) + " at frame " +
                                std::to_string(name.frame) + " " + body.pose_fault;
            }
            return;
        }
    }

    void note_stretch(const std::array<std::uint32_t, 2>& bodies) {
        for (const std::uint32_t number : bodies) {
            const BodyState& body = recording_.bodies().at(number);
            if (!body.is_stretched() || !stretched_.insert(number).second) continue;
            result_.stretches.push_back(name_of(number) + " is " + stretch_words(body.stretch) +
                                        " by its pose at frame " +
                                        std::to_string(recording_.frame()) + ", and judged so");
        }
    }

    /// Notes whether the first query with false pairs reported just the pairs within twice its
    /// tolerance.
    void note_twice(const EngineQuery& query, const QueryJudgement& judged, const QueryName& name) {
        const bool any =
            std::any_of(judged.pairs.begin(), judged.pairs.end(),
                        [](const PairProblem& pair) { return !is_missed(pair.cause); });
        if (!any || std::exchange(twice_tried_, true)) return;
        EngineQuery twice = query;
        twice.limit *= 2;
        if (own_.truth(twice, recording_.finite_meshes()).pairs != reported_pairs(query)) return;
        result_.notes.push_back(query_words(name) +
                                ": the reported pairs are the pairs within twice the tolerance, "
                                "as if the tolerance had been added twice");
    }

    void take_pairs(const EngineQuery& query, const QueryJudgement& judged, const QueryName& name,
                    FrameJudgement& row) {
        if (query.kind != QueryKind::distance) {
            row.pairs += judged.reported;
            result_.exact_pairs += judged.exact;
        }
        result_.not_looked_into += judged.not_looked_into;
        without_results_ += judged.without_results;
        broken_pairs_ += judged.broken;
        for (const PairProblem& problem : judged.pairs) {
            const bool missed = is_missed(problem.cause);
            (missed ? row.missed : row.false_pairs) += 1;
            add_case(
                missed ? missed_ : false_, words_of(query, problem.cause),
                {name, words_of(query, problem, test_number(judged, problem), recording_.stages()),
                 problem.nodes, problem.items, test_number(judged, problem),
                 !is_of_distance(query) && have_volumes(query, problem.nodes)});
        }
    }

    /// The number of the problem's test of volumes, as traces count them. For a pair that was
    /// reported without a test, the number of the test before the report.
    static std::uint32_t test_number(const QueryJudgement& judged, const PairProblem& problem) {
        if (problem.test != no_index || problem.event == no_index) return problem.test;
        const auto after = std::upper_bound(
            judged.tests.begin(), judged.tests.end(), problem.event,
            [](std::uint32_t at, const JudgedTest& test) { return at < test.event; });
        return after == judged.tests.begin()
                   ? no_index
                   : static_cast<std::uint32_t>(after - judged.tests.begin() - 1);
    }

    /// Other commands show the first of several queries of the same bodies in a frame. If the
    /// bodies moved in between, the queries belong to different frames.
    void note_moves(const EngineQuery& query, const QueryName& name) {
        const auto bodies = recording_.query_bodies();
        const auto [last, added] = last_queries_.try_emplace(bodies, query.frame, query.b_to_a);
        const bool moved = !added && last->second.first == query.frame &&
                           (last->second.second.rotation != query.b_to_a.rotation ||
                            last->second.second.translation != query.b_to_a.translation);
        last->second = {query.frame, query.b_to_a};
        if (moved && !std::exchange(moves_noted_, true))
            result_.notes.push_back("in frame " + std::to_string(query.frame) + ", " + name.a +
                                    " and " + name.b +
                                    " were queried at several poses; without --query and --tag, "
                                    "other commands show the first of them");
    }

    void not_judged(std::uint64_t count, std::uint64_t of, const std::string& what,
                    const std::string& why) {
        if (count > 0) result_.not_judged.push_back({count, of, what, why});
    }

    void list_not_judged() {
        not_judged(tolerances_.hidden(), tolerances_.of(), "triangles or leaf volumes",
                   tolerances_.why());
        not_judged(result_.frames_left, frames_judged_ + result_.frames_left, "frames",
                   "the judgement was interrupted");
        not_judged(unplaced_, queries_, "queries", unplaced_why_);
        not_judged(result_.unknown_items, queries_, "queries",
                   "their pairs are of objects that share leaves, have numbers above 999,999, or "
                   "were queried with triangles");
        not_judged(without_result_, queries_, "queries", "they ended early without a pair");
        for (const auto& [number, watch] : trees_.watches()) {
            const UnjudgedVolumes& of = watch.unjudged();
            not_judged(of.leaves, of.of_leaves, "leaf volumes of " + tree_words(recording_, number),
                       "the extents of their objects were not recorded (scb_record_object)");
            not_judged(of.slightly_open, recording_.trees().at(number).tree.size(),
                       "nodes of " + tree_words(recording_, number),
                       "their boxes do not contain what is below them, by up to " +
                           format("%.3g", of.open_by) +
                           ", which is within the tolerance; the setting `tolerance` says up to "
                           "which length the engine's numbers may be off");
            not_judged(of.dropped, 0, "triangles of " + tree_words(recording_, number),
                       "they have no area, and no leaf has them");
            not_judged(of.splits, of.of_splits,
                       "triangles in several leaves of " + tree_words(recording_, number),
                       "the curved surfaces of their leaves nearly coincide");
            const TreeState& tree = recording_.trees().at(number);
            if (tree.tree.size() == 0)
                not_judged(1, trees_.watches().size(), "trees",
                           tree_words(recording_, number) + " was recorded without nodes");
        }
        tests_.list_not_judged(result_.not_judged);
        distances_.list_not_judged(result_.not_judged);
        not_judged(unknown_kinds_, queries_, "queries",
                   recording_.unusable().count > 0 ? recording_.unusable().first[0]
                                                   : "their kind is not known");
        std::uint64_t reported = 0;
        for (const FrameJudgement& row : result_.frames) reported += row.pairs;
        const std::uint64_t pairs = std::max(reported, result_.exact_pairs);
        not_judged(result_.grazing, std::max(pairs, result_.grazing), "pairs",
                   "their distance or depth is within the tolerance" +
                       (grazing_missed_ == 0
                            ? ""
                            : "; of these, " + std::to_string(grazing_missed_) +
                                  " touch or intersect and were not reported, the first: " +
                                  first_grazing_));
        not_judged(unknown_objects_, objects_, "objects",
                   "they have no extent, and their leaf has no volume that can be judged");
        not_judged(recording_.broke_off() ? 1 : 0, queries_, "queries",
                   "the file breaks off in the last one");
        not_judged(result_.not_looked_into, pairs, "pairs",
                   "they were not reported, and of a query the first 100,000 are looked into");
        not_judged(broken_pairs_, reported, "pairs", "their triangles are not finite");
        not_judged(without_results_, without_results_, "pairs that intersect",
                   "the results of their queries were not recorded; where none was found, the "
                   "setting `results` with the value `pairs` says so");
        if (recording_.unfinished_tree())
            not_judged(
                1, trees_.watches().size(), "trees",
                "the file breaks off in " + tree_words(recording_, *recording_.unfinished_tree()));
        if (recording_.unusable().count > 0)
            not_judged(recording_.unusable().count, 0, "records", recording_.unusable().first[0]);
        not_judged(recording_.unknown_records(), 0, "records",
                   "this version does not know their kind");
    }

    void finish() {
        result_.poses = poses_.likely();
        if (poses_.lacks_poses() && result_.poses.empty())
            result_.notes.push_back(
                "the bodies of a query with wrong tests have no recorded pose; record the engine's "
                "poses with scb_record_pose");
        for (const RecordedSetting& setting : recording_.settings())
            if (setting.key == "engine" && result_.engine.empty()) result_.engine = setting.value;
        result_.trees = trees_.judged();
        result_.stages = tests_.stages(recording_.stages());
        result_.unjudged = tests_.unjudged();
        result_.missed = by_count(std::move(missed_));
        result_.false_pairs = by_count(std::move(false_));
        result_.answers = by_count(distances_.answers());
        result_.distances = distances_.count();
        result_.test_problems = by_count(tests_.problems());
        result_.odd = recording_.contradictions();
        result_.unusable = recording_.unusable();
        result_.damage = recording_.damage();
        list_not_judged();
        if (const std::optional<CostFinding> repeated = tests_.repeated())
            result_.costs.push_back(*repeated);
        for (CostFinding& cost : costs_.found(recording_, trees_, result_.trees))
            result_.costs.push_back(std::move(cost));
    }

    RecordingJudgement result_;
    RecordedQueries recording_;
    OwnContacts own_;
    TreeJudge trees_;
    ToleranceCheck tolerances_;
    QueryCosts costs_;
    TestFindings tests_;
    ProblemGroups missed_, false_;
    DistanceFindings distances_;
    std::uint64_t unknown_kinds_ = 0;  ///< queries whose kind is not known
    bool twice_tried_ = false;         ///< see note_twice
    PoseSearch poses_;
    bool moves_noted_ = false;
    // What was not judged, and why.
    std::uint64_t queries_ = 0, unplaced_ = 0, without_result_ = 0, without_results_ = 0,
                  broken_pairs_ = 0;
    std::string unplaced_why_;
    std::set<std::uint32_t> stretched_;  ///< bodies whose stretch was noted
    const std::function<bool()> go_on_;
    const JudgedQueryVisitor visit_;
    std::uint64_t frames_judged_ = 0;   ///< of an interrupted judgement
    std::uint64_t grazing_missed_ = 0;  ///< see QueryJudgement
    std::string first_grazing_;
    std::uint64_t unknown_objects_ = 0, objects_ = 0;  ///< the largest numbers of any query
    /// Per pair of bodies, the frame and the pose of their last query.
    std::map<std::array<std::uint32_t, 2>, std::pair<int, Pose>> last_queries_;
};

}  // namespace

std::uint64_t RecordingJudgement::total(std::uint64_t FrameJudgement::*count) const {
    std::uint64_t result = 0;
    for (const FrameJudgement& frame : frames) result += frame.*count;
    return result;
}

Verdict RecordingJudgement::verdict() const {
    const bool tree = std::any_of(trees.begin(), trees.end(), [](const TreeJudgement& judged) {
        return !judged.problems.empty();
    });
    if (tree || !missed.empty() || !false_pairs.empty() || !answers.empty() ||
        !test_problems.empty() || !poses.empty() || odd.count > 0)
        return Verdict::wrong;
    return not_judged.empty() && damage.empty() ? Verdict::valid : Verdict::partly_judged;
}

RecordingJudgement judge_recording(const RecordingFile& file,
                                   const std::function<bool(int)>& wanted,
                                   const std::function<bool(bool)>& done,
                                   const JudgedQueryVisitor& visit) {
    return RecordingJudge(
               file, [&done] { return done(false); }, visit)
        .judged(wanted, done);
}

}  // namespace scb::scenes
