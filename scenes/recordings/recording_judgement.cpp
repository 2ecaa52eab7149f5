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
        for (const auto& [i, margin, strayed, unknown] : judged.wrong_item_tests) {
            const EngineEvent& event = query.events[i];
            ++row.wrong;
            const bool meet = event.kind == EngineEvent::Kind::items_meet;
            const std::uint32_t number = test_number(judged, i);
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
        row.wasted += judged.wasted_weak + judged.wasted_loose;
        result_.wasted_weak += judged.wasted_weak;
        result_.wasted_loose += judged.wasted_loose;
        result_.grazing += judged.grazing;
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
                 test_number(judged, problem.event)});
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
                next += (next.empty() ? "node " : " or node ") + std::to_string(problem.next.b) +
                        " of B";
            words += ", from which the way leads to " + next;
        }
        words += test_words(test_number(judged, problem.event));
        if (problem.event != no_index && problem.event < query.events.size() &&
            query.events[problem.event].kind == EngineEvent::Kind::volumes &&
            query.events[problem.event].stage != 0)
            words += ", stage \"" + stage_name(query.events[problem.event].stage) + "\"";
        return words;
    }

    /// The test of volumes that the event is, or that came before it, as traces count them.
    static std::uint32_t test_number(const QueryJudgement& judged, std::uint32_t event) {
        if (event == no_index) return no_index;
        const auto after = std::upper_bound(
            judged.tests.begin(), judged.tests.end(), event,
            [](std::uint32_t at, const JudgedTest& test) { return at < test.event; });
        return after == judged.tests.begin()
                   ? no_index
                   : static_cast<std::uint32_t>(after - judged.tests.begin() - 1);
    }

    static std::string test_words(std::uint32_t number) {
        return number == no_index ? "" : ", test " + std::to_string(number);
    }

    /// Another pose with which no test is wrong.
    void find_pose(const EngineQuery& query, const QueryName& name) {
        const PoseFit told = fit_of_pose(query, query.b_to_a);
        std::vector<std::pair<std::string, Pose>> others;
        if (query.b_to_a_before)
            others.emplace_back("the pose of the frame before", *query.b_to_a_before);
        const Pose& pose = query.b_to_a;
        const Mat3 turned = pose.rotation.transpose();
        others.emplace_back("the pose with its rotation transposed",
                            Pose{turned, pose.translation});
        others.emplace_back("the inverse of the pose",
                            Pose{turned, -rotate(turned, pose.translation)});
        others.emplace_back("the pose without its rotation",
                            Pose{Mat3::Identity(), pose.translation});
        others.emplace_back("the pose without its translation", Pose{pose.rotation, Vec3::Zero()});
        const auto fits_all = [&](const EngineQuery& asked, const Pose& with,
                                  const std::string& what) {
            const PoseFit fits = fit_of_pose(asked, with);
            if (fits.wrong > 0 || fits.false_positive > told.false_positive) return false;
            result_.poses.push_back({name, what, told, fits});
            return true;
        };
        for (const auto& [what, other] : others)
            if (fits_all(query, other, what)) return;
        EngineQuery swapped = query;
        for (EngineEvent& event : swapped.events) std::swap(event.a, event.b);
        fits_all(swapped, query.b_to_a, "the pose, were those of B named before those of A");
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
