#include "scenes/recordings/recording_judgement.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/enum_names.h"
#include "core/base/text_format.h"
#include "scenes/recordings/own_contacts.h"

namespace scb::scenes {
namespace {

constexpr EnumNames<PairCause, pair_cause_count> cause_names = {
    "a triangle is in no leaf",
    "rejected at a node that does not contain the triangle",
    "rejected although the volumes overlap",
    "what is below two overlapping nodes was never tested",
    "no test of nodes above the triangles was made",
    "the triangles of two overlapping leaves were never tested",
    "the test of the two triangles said that they are apart",
    "found, but not reported",
    "reported although their test said that they are apart",
    "the test of the two triangles said that they meet",
    "reported without a test of the two triangles",
    "one of the two does not exist",
    "reported twice",
};

/// Of items that are objects.
std::string for_objects(std::string words) {
    constexpr std::string_view triangle = "triangle", object = "object";
    for (std::size_t at = words.find(triangle); at != std::string::npos;
         at = words.find(triangle, at + object.size()))
        words.replace(at, triangle.size(), object);
    return words;
}

std::string pair_words(const char* what, std::uint32_t a, std::uint32_t b) {
    return std::string(what) + " " + std::to_string(a) + " of A and " + std::to_string(b) + " of B";
}

std::string name_of_body(const RecordedQueries& recording, std::uint32_t number) {
    const std::string& name = recording.bodies().at(number).name;
    return name.empty() ? "body " + std::to_string(number) : name;
}

std::string query_words(const QueryName& query) {
    return "frame " + std::to_string(query.frame) + ", " + query.a + " and " + query.b;
}

/// Adds query after query.
class RecordingJudge {
  public:
    RecordingJudge(std::string_view bytes, std::string_view name) {
        result_.summary = summary_of(bytes, name);
        recording_.emplace(bytes, name, result_.summary);
    }

    RecordingJudgement judged(const std::function<bool(int)>& wanted,
                              const std::function<bool()>& done) && {
        for (;;) {
            const RecordedQueries::Step step = recording_->next();
            if (step == RecordedQueries::Step::end) break;
            const bool want = wanted(recording_->frame());
            if (step == RecordedQueries::Step::query) {
                if (want) take_query(recording_->query());
                continue;
            }
            if (!want) continue;
            for (const auto& [number, tree] : recording_->trees()) look(number);
            frame();
            if (!done()) break;
        }
        finish();
        return std::move(result_);
    }

  private:
    FrameJudgement& frame() {
        if (result_.frames.empty() || result_.frames.back().frame != recording_->frame())
            result_.frames.push_back({recording_->frame()});
        return result_.frames.back();
    }

    void look(std::uint32_t number) {
        TreeWatch& watch = watches_[number];
        if (recording_->unfinished_tree() == number) return;
        const EngineSide side = recording_->side_of(number);
        const TreeState& tree = recording_->trees().at(number);
        watch.look(recording_->frame(), *side.tree, *side.shape, side.mesh,
                   recording_->tolerance_of(tree), tree.version, tree.volume_version);
    }

    void take_query(const EngineQuery& query) {
        const auto bodies = recording_->query_bodies();
        for (const std::uint32_t body : bodies) look(recording_->bodies().at(body).tree);
        const QueryName name{query.frame, name_of_body(*recording_, bodies[0]),
                             name_of_body(*recording_, bodies[1])};
        FrameJudgement& row = frame();
        ++row.queries;
        result_.nanoseconds += query.nanoseconds;
        result_.self_queries += query.self;
        result_.ended_early += !query.complete;
        result_.unknown_items += !query.self && !has_known_items(query);
        if (!query.rigid) {
            add(tests_, "a query's pose is not rigid", {name, "it is not judged"});
            return;
        }
        note_moves(query, name);
        const QueryJudgement judged =
            judge_query(query, own_.contacts(query, recording_->meshes()));
        take_tests(query, judged, name, row);
        take_pairs(query, judged, name, row);
        const bool errs =
            std::any_of(judged.wrong_item_tests.begin(), judged.wrong_item_tests.end(),
                        [](const WrongItemTest& test) { return !test.unknown; });
        if (judged.count(TestVerdict::wrong) > 0 || errs) find_pose(query, name);
    }

    void take_tests(const EngineQuery& query, const QueryJudgement& judged, const QueryName& name,
                    FrameJudgement& row) {
        for (std::uint32_t number = 0; number < judged.tests.size(); ++number) {
            const JudgedTest& test = judged.tests[number];
            const EngineEvent& event = query.events[test.event];
            StageJudgement& stage = stages_[event.stage];
            ++stage.tests;
            ++row.volume_tests;
            stage.false_positives += test.verdict == TestVerdict::false_positive;
            result_.unjudged += test.verdict == TestVerdict::unjudged;
            const auto note = [&](const std::string& what, const std::string& more = {}) {
                add(tests_, what,
                    {name,
                     pair_words("nodes", event.a, event.b) + test_words(number) + more,
                     {event.a, event.b},
                     {no_index, no_index},
                     number});
            };
            if (test.nodes.a == no_index || test.nodes.b == no_index)
                note("a test of a node that its tree does not have");
            if (test.repeated) note("a test that the query had made before");
            if (test.verdict != TestVerdict::wrong) continue;
            ++row.wrong;
            stage.least_depth =
                stage.wrong == 0 ? test.margin : std::min(stage.least_depth, test.margin);
            stage.most_depth = std::max(stage.most_depth, test.margin);
            ++stage.wrong;
            note("a test that rejected volumes which overlap, at stage \"" +
                     stage_name(event.stage) + "\"",
                 ", " + format("%.6g", test.margin) + " deep in each other");
        }
        row.item_tests += judged.item_tests;
        for (const auto& [i, number, margin, strayed, unknown] : judged.wrong_item_tests) {
            const EngineEvent& event = query.events[i];
            ++row.wrong;
            const bool meet = event.kind == EngineEvent::Kind::items_meet;
            if (unknown) {
                add(tests_, "a test of a triangle that its mesh does not have",
                    {name,
                     pair_words("triangles", event.a, event.b) + test_words(number),
                     {no_index, no_index},
                     {no_index, no_index},
                     number});
                continue;
            }
            add(tests_,
                meet ? "a test said that two triangles meet which do not"
                     : "a test said that two triangles are apart which intersect",
                {name,
                 pair_words("triangles", event.a, event.b) + test_words(number) + ", " +
                     format("%.6g", margin) + (meet ? " apart" : " deep in each other") +
                     (strayed ? "; the nodes that have them were not tested before, so are these "
                                "their numbers?"
                              : ""),
                 {no_index, no_index},
                 {event.a, event.b},
                 number});
        }
        for (const WrongItemTest& stray : judged.stray_item_tests) {
            const EngineEvent& event = query.events[stray.event];
            const std::uint32_t number = stray.test;
            ++row.wrong;
            add(tests_, "a test of triangles that are not in the leaves that were tested before",
                {name,
                 pair_words("triangles", event.a, event.b) + test_words(number) +
                     "; are these their numbers?",
                 {no_index, no_index},
                 {event.a, event.b},
                 number});
        }
        take_divisions(query, judged, name);
        row.wasted += judged.wasted_weak + judged.wasted_loose;
        result_.wasted_weak += judged.wasted_weak;
        result_.wasted_loose += judged.wasted_loose;
        result_.grazing += judged.grazing;
    }

    void take_divisions(const EngineQuery& query, const QueryJudgement& judged,
                        const QueryName& name) {
        const DivisionCounts& here = judged.divisions;
        if (here.lacking > 0 && lacking_.empty()) {
            const JudgedTest& test = judged.tests[here.first.test];
            lacking_ = query_words(name) + ": " +
                       pair_words("nodes", (*query.sides[0].tree)[test.nodes.a].number,
                                  (*query.sides[1].tree)[test.nodes.b].number) +
                       test_words(here.first.test) + ", where node " +
                       std::to_string(here.first.child) + " of " +
                       (here.first.side == 0 ? "A" : "B") + " was not tested";
            first_lack_ = here.first;
        }
        if (here.lacking > 0)
            lacks_alike_ = lacks_alike_ && here.alike && here.first.side == first_lack_.side &&
                           here.first.place == first_lack_.place;
        divided_ += here.divided;
        lacks_ += here.lacking;
    }

    /// Who leaves out children in most divisions means it.
    void note_lacking_children() {
        if (lacks_ == 0 || 2 * lacks_ > divided_) return;
        std::string note =
            std::to_string(lacks_) + " of " + std::to_string(divided_) +
            " divisions of a node did not lead to a test of each child; the first: " + lacking_;
        if (lacks_alike_ && lacks_ > 1)
            note += std::string("; in all of them it is child ") +
                    std::to_string(first_lack_.place + 1) + " of the node of " +
                    (first_lack_.side == 0 ? "A" : "B");
        result_.notes.push_back(std::move(note));
    }

    void take_pairs(const EngineQuery& query, const QueryJudgement& judged, const QueryName& name,
                    FrameJudgement& row) {
        row.pairs += judged.reported;
        result_.exact_pairs += judged.exact;
        result_.not_looked_into += judged.not_looked_into;
        for (const PairProblem& problem : judged.pairs) {
            const bool missed = is_missed(problem.cause);
            (missed ? row.missed : row.false_pairs) += 1;
            add(missed ? missed_ : false_, words_of(query, problem.cause),
                {name, words_of(query, judged, problem), problem.nodes, problem.items,
                 test_number(judged, problem)});
        }
    }

    static std::string words_of(const EngineQuery& query, PairCause cause) {
        const std::string words(cause_names[cause]);
        return query.sides[0].mesh ? words : for_objects(words);
    }

    std::string words_of(const EngineQuery& query, const QueryJudgement& judged,
                         const PairProblem& problem) const {
        const std::string words = triangle_words(query, judged, problem);
        return query.sides[0].mesh ? words : for_objects(words);
    }

    std::string triangle_words(const EngineQuery& query, const QueryJudgement& judged,
                               const PairProblem& problem) const {
        std::string words = pair_words("triangles", problem.items.a, problem.items.b);
        const std::uint32_t item = problem.side == 0 ? problem.items.a : problem.items.b,
                            node = problem.side == 0 ? problem.nodes.a : problem.nodes.b;
        const std::string side = problem.side == 0 ? "A" : "B";
        if (problem.cause == PairCause::in_no_leaf)
            words += "; no leaf of " + side + " has triangle " + std::to_string(item);
        if (problem.nodes.a != no_index)
            words += "; at " + pair_words("nodes", problem.nodes.a, problem.nodes.b);
        if (problem.cause == PairCause::not_contained)
            words += ", of which node " + std::to_string(node) + " of " + side +
                     " does not contain triangle " + std::to_string(item) + ", by " +
                     format("%.6g", problem.amount);
        if (problem.cause == PairCause::never_visited) {
            std::string next;
            if (problem.next.a != no_index)
                next = "node " + std::to_string(problem.next.a) + " of A";
            if (problem.next.b != no_index)
                next += (next.empty() ? "node " : ", to node ") + std::to_string(problem.next.b) +
                        " of B" + (next.empty() ? "" : ", or to both");
            words += ", from which the way leads to " + next;
        }
        words += test_words(test_number(judged, problem));
        if (problem.event != no_index && problem.event < query.events.size() &&
            query.events[problem.event].kind == EngineEvent::Kind::volumes &&
            query.events[problem.event].stage != 0)
            words += ", stage \"" + stage_name(query.events[problem.event].stage) + "\"";
        return words;
    }

    /// The test of volumes that the problem is at or, of a pair that was reported without one, the
    /// one before it, as traces count them.
    static std::uint32_t test_number(const QueryJudgement& judged, const PairProblem& problem) {
        if (problem.test != no_index || problem.event == no_index) return problem.test;
        const auto after = std::upper_bound(
            judged.tests.begin(), judged.tests.end(), problem.event,
            [](std::uint32_t at, const JudgedTest& test) { return at < test.event; });
        return after == judged.tests.begin()
                   ? no_index
                   : static_cast<std::uint32_t>(after - judged.tests.begin() - 1);
    }

    static std::string test_words(std::uint32_t number) {
        return number == no_index ? "" : ", test " + std::to_string(number);
    }

    /// Other poses that the tests may have been made with, the likeliest first.
    std::vector<std::pair<std::string, Pose>> other_poses(const EngineQuery& query) const {
        std::vector<std::pair<std::string, Pose>> others;
        if (query.b_to_a_before)
            others.emplace_back("the pose of the frame before", *query.b_to_a_before);
        const auto transposed = [](const Pose& pose) {
            return Pose{pose.rotation.transpose(), pose.translation};
        };
        const Pose& pose = query.b_to_a;
        others.emplace_back("the pose with its rotation transposed", transposed(pose));
        const Mat3 turned = pose.rotation.transpose();
        others.emplace_back("the inverse of the pose",
                            Pose{turned, -rotate(turned, pose.translation)});
        const auto bodies = recording_->query_bodies();
        const Pose &a = recording_->bodies().at(bodies[0]).pose,
                   &b = recording_->bodies().at(bodies[1]).pose;
        others.emplace_back("the poses with the rotation of B transposed",
                            relative_pose(a, transposed(b)));
        others.emplace_back("the poses with the rotation of A transposed",
                            relative_pose(transposed(a), b));
        others.emplace_back("the poses with both rotations transposed",
                            relative_pose(transposed(a), transposed(b)));
        others.emplace_back("the pose without its rotation",
                            Pose{Mat3::Identity(), pose.translation});
        others.emplace_back("the pose without its translation", Pose{pose.rotation, Vec3::Zero()});
        return others;
    }

    /// Another pose with which no test is wrong, or at least none of volumes.
    void find_pose(const EngineQuery& query, const QueryName& name) {
        ++erring_queries_;
        const PoseFit told = fit_of_pose(query, query.b_to_a);
        const auto fits_all = [&](const EngineQuery& asked, const Pose& with,
                                  const std::string& what, bool only_volumes) {
            const PoseFit fits = fit_of_pose(asked, with);
            if (fits.wrong > 0 || fits.false_positive > told.false_positive) return false;
            if (only_volumes ? told.wrong_items > 0 || told.wrong == 0 : fits.wrong_items > 0)
                return false;
            result_.poses.push_back({name, what, told, fits, only_volumes});
            return true;
        };
        const auto others = other_poses(query);
        for (const auto& [what, other] : others)
            if (fits_all(query, other, what, false)) return;
        EngineQuery swapped = query;
        for (EngineEvent& event : swapped.events) std::swap(event.a, event.b);
        if (fits_all(swapped, query.b_to_a,
                     "the pose that was told if each names a node of " + name.b +
                         " first, and of " + name.a + " second, the other way round than the query",
                     false))
            return;
        for (const auto& [what, other] : others)
            if (fits_all(query, other, what, true)) return;
        const auto bodies = recording_->query_bodies();
        not_placed_ |= !recording_->bodies().at(bodies[0]).placed &&
                       !recording_->bodies().at(bodies[1]).placed;
    }

    /// What fits only here and there fits by chance.
    void keep_likely_poses() {
        std::map<std::string, std::size_t> counts;
        for (const PoseProblem& problem : result_.poses) ++counts[problem.pose];
        std::erase_if(result_.poses, [&](const PoseProblem& problem) {
            return 2 * counts[problem.pose] <= erring_queries_;
        });
        if (not_placed_ && result_.poses.empty())
            result_.notes.push_back(
                "no pose was told of the bodies of a query whose tests are wrong; tell those that "
                "the engine has, with scb_record_pose");
    }

    /// Of several queries of the same bodies in a frame, commands other than this one show the
    /// first: where the bodies have moved in between, frames were meant.
    void note_moves(const EngineQuery& query, const QueryName& name) {
        const auto bodies = recording_->query_bodies();
        const auto [last, added] = last_queries_.try_emplace(bodies, query.frame, query.b_to_a);
        const bool moved = !added && last->second.first == query.frame &&
                           (last->second.second.rotation != query.b_to_a.rotation ||
                            last->second.second.translation != query.b_to_a.translation);
        last->second = {query.frame, query.b_to_a};
        if (moved && !std::exchange(moves_noted_, true))
            result_.notes.push_back("in frame " + std::to_string(query.frame) + ", " + name.a +
                                    " and " + name.b +
                                    " were queried at several poses, of which other commands show "
                                    "the first; begin a frame for each, with scb_record_frame");
    }

    std::string stage_name(std::uint8_t stage) const {
        if (stage == 0) return "overlap";
        const auto found = recording_->stages().find(stage);
        return found == recording_->stages().end() ? "stage " + std::to_string(stage)
                                                   : found->second;
    }

    using Groups = std::vector<ProblemGroup>;
    static void add(Groups& groups, const std::string& what, ProblemCase one) {
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&what](const ProblemGroup& g) { return g.what == what; });
        if (group == groups.end()) group = groups.insert(group, ProblemGroup{what, 0, {}});
        ++group->count;
        if (group->cases.size() < ProblemGroup::most_cases) group->cases.push_back(std::move(one));
    }

    void finish() {
        keep_likely_poses();
        note_lacking_children();
        for (const RecordedSetting& setting : recording_->settings())
            if (setting.key == "engine" && result_.engine.empty()) result_.engine = setting.value;
        for (const auto& [number, watch] : watches_) {
            const TreeState& tree = recording_->trees().at(number);
            TreeJudgement judged{number,
                                 tree.name,
                                 tree.tree.size(),
                                 0,
                                 recording_->unfinished_tree() == number,
                                 watch.problems()};
            for (const std::uint32_t i : recording_->side_of(number).shape->order)
                judged.depth = std::max(judged.depth, recording_->side_of(number).shape->depths[i]);
            result_.trees.push_back(std::move(judged));
        }
        for (const auto& [stage, name] : recording_->stages()) stages_[stage].name = name;
        for (auto& [stage, judged] : stages_) {
            judged.name = stage_name(stage);
            result_.stages.push_back(judged);
        }
        const auto sorted = [](Groups groups) {
            std::stable_sort(
                groups.begin(), groups.end(),
                [](const ProblemGroup& a, const ProblemGroup& b) { return a.count > b.count; });
            return groups;
        };
        result_.missed = sorted(std::move(missed_));
        result_.false_pairs = sorted(std::move(false_));
        result_.test_problems = sorted(std::move(tests_));
        result_.odd = recording_->oddities();
        result_.more_odd = recording_->more_oddities();
        result_.damage = recording_->damage();
    }

    RecordingJudgement result_;
    std::optional<RecordedQueries> recording_;
    OwnContacts own_;
    std::map<std::uint32_t, TreeWatch> watches_;
    std::map<std::uint8_t, StageJudgement> stages_;
    Groups missed_, false_, tests_;
    std::size_t erring_queries_ = 0;
    bool not_placed_ = false, moves_noted_ = false;
    std::uint64_t divided_ = 0, lacks_ = 0;  ///< see DivisionCounts
    DivisionCounts::Lack first_lack_;
    std::string lacking_;  ///< which that is
    bool lacks_alike_ = true;
    /// Of two bodies the frame of the last query, and its pose.
    std::map<std::array<std::uint32_t, 2>, std::pair<int, Pose>> last_queries_;
};

}  // namespace

bool RecordingJudgement::wrong() const {
    const bool tree = std::any_of(trees.begin(), trees.end(), [](const TreeJudgement& judged) {
        return !judged.problems.empty();
    });
    return tree || !missed.empty() || !false_pairs.empty() || !test_problems.empty() ||
           !poses.empty() || !odd.empty();
}

RecordingJudgement judge_recording(std::string_view bytes, std::string_view name,
                                   const std::function<bool(int)>& wanted,
                                   const std::function<bool()>& done) {
    return RecordingJudge(bytes, name).judged(wanted, done);
}

}  // namespace scb::scenes
