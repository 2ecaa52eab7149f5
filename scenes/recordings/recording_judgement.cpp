#include "scenes/recordings/recording_judgement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/base/enum_names.h"
#include "core/base/text_format.h"
#include "core/judge/tight_tests.h"
#include "scenes/recordings/own_contacts.h"

namespace scb::scenes {
namespace {

constexpr EnumNames<PairCause, pair_cause_count> cause_names = {
    "the tree has no nodes",
    "a triangle is in no leaf",
    "rejected at a node that does not contain the triangle",
    "rejected at a node whose volume is none",
    "rejected although the volumes overlap",
    "what is below two overlapping nodes was never tested",
    "below a node that does not contain the triangle",
    "below a node whose volume is none",
    "no tests of volumes were recorded, so that the cause is not known",
    "no test of nodes above the triangles was made",
    "the triangles of two overlapping leaves were never tested",
    "the test of the two triangles said that they are apart",
    "found, but not reported",
    "reported although their test said that they are apart",
    "the test of the two triangles said that they meet",
    "reported without a test of the two triangles",
    "the two triangles share a vertex and meet nowhere else",
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
                              const std::function<bool(bool)>& done) && {
        for (;;) {
            const RecordedQueries::Step step = recording_->next();
            if (step == RecordedQueries::Step::end) break;
            const bool want = wanted(recording_->frame());
            if (step == RecordedQueries::Step::query) {
                if (want) take_query(recording_->query());
                if (want && !done(false)) break;
                continue;
            }
            if (!want) continue;
            for (const auto& [number, tree] : recording_->trees()) look(number);
            frame();
            if (!done(true)) break;
        }
        finish();
        return std::move(result_);
    }

  private:
    FrameJudgement& frame() {
        if (result_.frames.empty() || result_.frames.back().frame != recording_->frame())
            result_.frames.emplace_back().frame = recording_->frame();
        return result_.frames.back();
    }

    void look(std::uint32_t number) {
        TreeWatch& watch = watches_[number];
        if (recording_->unfinished_tree() == number) return;
        const EngineSide side = recording_->side_of(number);
        const TreeState& tree = recording_->trees().at(number);
        watch.look(recording_->frame(),
                   {*side.tree, *side.shape, side.mesh, recording_->tolerance_of(tree),
                    tree.version, tree.volume_version});
        const auto mesh = recording_->meshes().find(tree.mesh);
        if (mesh == recording_->meshes().end()) return;
        keep_mesh(tree.mesh, mesh->second);
        find_fit(number, side, mesh->second, recording_->tolerance_of(tree));
    }

    /// Meshes of earlier frames, of which a tree may be that was not refitted.
    void keep_mesh(std::uint32_t number, const MeshState& mesh) {
        constexpr std::size_t most = 8;
        std::deque<EarlierMesh>& kept = earlier_[number];
        if (!kept.empty() && kept.back().version == mesh.version) return;
        kept.push_back({mesh.version, mesh.told_at, mesh.finite});
        if (kept.size() > most) kept.pop_front();
    }

    /// One change that explains why nodes do not contain what is below them: at the frame with the
    /// most of them, but not in each of many frames.
    void find_fit(std::uint32_t number, const EngineSide& side, const MeshState& mesh,
                  double tolerance) {
        const TreeWatch& watch = watches_[number];
        TreeFitting& fitting = fits_[number];
        constexpr int most_tries = 3;
        if (watch.most_outside() == 0 || watch.most_outside_at() != recording_->frame() ||
            fitting.fit || fitting.tries >= most_tries ||
            watch.most_outside() < 2 * fitting.outside)
            return;
        ++fitting.tries;
        fitting.outside = watch.most_outside();
        fitting.frame = recording_->frame();
        std::vector<OtherMesh> others;
        const std::deque<EarlierMesh>& kept = earlier_[recording_->trees().at(number).mesh];
        for (auto earlier = kept.rbegin(); earlier != kept.rend(); ++earlier)
            if (earlier->mesh != mesh.finite)
                others.push_back(
                    {"the mesh of frame " + std::to_string(earlier->frame), *earlier->mesh});
        for (const auto& [body_number, body] : recording_->bodies()) {
            if (body.tree != number || !body.placed || !body.pose_fault.empty()) continue;
            const auto in_world = [&, stretch = body.stretch](const Pose& pose) {
                Mesh placed = *mesh.finite;
                for (Vec3& vertex : placed.vertices)
                    vertex = transform_point(pose, rotate(stretch, vertex));
                return placed;
            };
            const std::string of = " of " + name_of(body_number);
            others.push_back({"the pose" + of + ", as of volumes in the world",
                              in_world(body.pose)});
            if (body.last)
                others.push_back({"the pose" + of + " in the frame before, as of volumes in the "
                                                    "world",
                                  in_world(*body.last)});
        }
        fitting.fit = find_tree_fit(*side.tree, *side.shape, *mesh.finite, tolerance,
                                    watch.most_outside(), others);
    }

    void take_query(const EngineQuery& query) {
        const auto bodies = recording_->query_bodies();
        for (const std::uint32_t body : bodies) look(recording_->bodies().at(body).tree);
        const QueryName name{query.frame, name_of(bodies[0]), name_of(bodies[1])};
        FrameJudgement& row = frame();
        ++row.queries;
        ++queries_;
        result_.nanoseconds += query.nanoseconds;
        result_.ended_early += !query.complete;
        if (!query.placed) {
            take_faulty_pose(name);
            return;
        }
        note_stretch(bodies);
        const bool known = has_known_items(query);
        result_.unknown_items += !known;
        note_moves(query, name);
        const QueryJudgement judged =
            judge_query(query, own_.contacts(query, recording_->finite_meshes()));
        take_tolerance(query, row);
        take_tests(query, judged, name, row);
        take_pairs(query, judged, name, row);
        take_looseness(query, judged);
        without_result_ += !query.complete && known && judged.reported == 0;
        const bool errs =
            std::any_of(judged.wrong_item_tests.begin(), judged.wrong_item_tests.end(),
                        [](const WrongItemTest& test) { return !test.unknown; });
        if (judged.count(TestVerdict::wrong) > 0 || errs)
            poses_.take(query, name, recording_->bodies().at(bodies[0]),
                        recording_->bodies().at(bodies[1]));
    }

    std::string name_of(std::uint32_t body) const {
        return result_.summary.body_names.at(body);
    }

    void take_faulty_pose(const QueryName& name) {
        for (const std::uint32_t number : recording_->query_bodies()) {
            const BodyState& body = recording_->bodies().at(number);
            if (body.pose_fault.empty()) continue;
            if (!body.is_finite) {
                add(tests_, "a query's pose is not finite", {name, "it is not judged"});
            } else if (unplaced_++ == 0) {
                unplaced_why_ = "the pose of " + name_of(number) + " at frame " +
                                std::to_string(name.frame) + " " + body.pose_fault;
            }
            return;
        }
    }

    void note_stretch(const std::array<std::uint32_t, 2>& bodies) {
        for (const std::uint32_t number : bodies) {
            const BodyState& body = recording_->bodies().at(number);
            if (!body.is_stretched() || !stretched_.insert(number).second) continue;
            result_.stretches.push_back(name_of(number) + " is " + stretch_words(body.stretch) +
                                        " by its pose at frame " +
                                        std::to_string(recording_->frame()) +
                                        ", and judged so");
        }
    }

    /// The tolerance of the frame, and whether it is larger than what is to be judged.
    void take_tolerance(const EngineQuery& query, FrameJudgement& row) {
        FrameTolerance& tolerance = row.tolerance;
        tolerance.volumes = std::max(tolerance.volumes, query.tolerance);
        tolerance.triangles = std::max(tolerance.triangles, query.triangle_tolerance);
        tolerance.away = std::max(tolerance.away, query.away);
        tolerance.single |= query.single;
        const auto bodies = recording_->query_bodies();
        for (std::size_t side = 0; side < 2; ++side) {
            const double size = size_of_items(bodies[side], query.sides[side]);
            const bool has_mesh = query.sides[side].mesh;
            const double within = has_mesh ? query.triangle_tolerance : query.tolerance;
            if (!(size > 0) || within < size) continue;
            ++hidden_;
            if (tolerance.hides.empty())
                tolerance.hides =
                    (has_mesh ? "half of the triangles of " : "half of the leaf volumes of ") +
                    name_of(bodies[side]) + " are smaller than " + format("%.3g", size);
            if (hidden_why_.empty())
                hidden_why_ = "at frame " + std::to_string(query.frame) + " the tolerance is " +
                              format("%.3g", within) + ", and " + tolerance.hides +
                              cause_of_tolerance(query);
            return;
        }
    }

    static std::string cause_of_tolerance(const EngineQuery& query) {
        if (!(query.away > 0)) return "";
        const double step = query.away * (query.single ? 0x1p-23 : 0x1p-52);
        return "; bodies stand " + format("%.3g", query.away) + " from the origin, where " +
               (query.single ? "32" : "64") + "-bit numbers are up to " + format("%.2g", step) +
               " apart";
    }

    /// Half of the triangles, or of the volumes of leaves, of a body are smaller.
    double size_of_items(std::uint32_t body, const EngineSide& side) {
        const int version =
            recording_->trees().at(recording_->bodies().at(body).tree).volume_version;
        SizeOfItems& known = sizes_[body];
        if (known.tree == side.tree && known.version == version) return known.size;
        known.tree = side.tree;
        known.version = version;
        std::vector<double> sizes;
        if (side.mesh) {
            for (std::uint32_t i = 0; i < side.mesh->triangles.size(); ++i) {
                if (!has_finite_corners(*side.mesh, i)) continue;
                const TriangleCorners t = corners(*side.mesh, i);
                sizes.push_back(std::sqrt(std::max({squared_norm(Vec3(t[1] - t[0])),
                                                    squared_norm(Vec3(t[2] - t[1])),
                                                    squared_norm(Vec3(t[0] - t[2]))})));
            }
        } else {
            for (const std::uint32_t node : side.shape->order)
                if (side.shape->is_leaf(node) && has_volume((*side.tree)[node].volume))
                    sizes.push_back(diameter(convex_shape((*side.tree)[node].volume)));
        }
        if (sizes.empty()) return known.size = 0;
        const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
        std::nth_element(sizes.begin(), middle, sizes.end());
        return known.size = *middle;
    }

    /// What boxes that fit would save, where many do not.
    void take_looseness(const EngineQuery& query, const QueryJudgement& judged) {
        if (judged.tests.empty()) return;
        const auto bodies = recording_->query_bodies();
        bool any = false;
        for (std::size_t side = 0; side < 2; ++side) {
            const std::uint32_t number = recording_->bodies().at(bodies[side]).tree;
            const TightBoxes& tight = tight_of(bodies[side], query.sides[side]);
            if (tight.boxes < 8 || 4 * tight.loose < tight.boxes) continue;
            any = true;
            const auto [known, added] = loose_.try_emplace(number);
            if (added)
                known->second.where = tree_words(number) + " since frame " +
                                      std::to_string(recording_->frame());
            if (tight.loose > known->second.count)
                known->second = {CostFinding::Kind::loose, tight.loose, tight.boxes,
                                 known->second.where, 0, 0};
        }
        loose_tests_ += judged.tests.size();
        loose_tests_if_tight_ += any ? tests_with(query, judged.tests, tight_[bodies[0]].boxes,
                                                  tight_[bodies[1]].boxes)
                                     : judged.tests.size();
    }

    const TightBoxes& tight_of(std::uint32_t body, const EngineSide& side) {
        const int version =
            recording_->trees().at(recording_->bodies().at(body).tree).volume_version;
        TightOfBody& known = tight_[body];
        if (known.tree != side.tree || known.version != version)
            known = {side.tree, version, tight_boxes(side)};
        return known.boxes;
    }

    std::string tree_words(std::uint32_t number) const {
        const std::string& name = recording_->trees().at(number).name;
        return "tree " + std::to_string(number) + (name.empty() ? "" : " \"" + name + "\"");
    }

    void take_tests(const EngineQuery& query, const QueryJudgement& judged, const QueryName& name,
                    FrameJudgement& row) {
        for (std::uint32_t number = 0; number < judged.tests.size(); ++number) {
            const JudgedTest& test = judged.tests[number];
            const EngineEvent& event = query.events[test.event];
            StageJudgement& stage = stages_[event.stage];
            ++stage.tests;
            ++row.volume_tests;
            unjudged_tests_ += test.verdict == TestVerdict::unjudged;
            tests_of_all_ += 1;
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
            if (test.repeated && repeated_++ == 0)
                first_repeated_ = query_words(name) + ": " +
                                  pair_words("nodes", event.a, event.b) + test_words(number);
            if (test.verdict == TestVerdict::false_positive) {
                ++stage.false_positives;
                if (test.margin > stage.most_apart) {
                    stage.most_apart = test.margin;
                    stage.farthest = query_words(name) + ": " +
                                     pair_words("nodes", event.a, event.b) + test_words(number) +
                                     ", " + format("%.6g", test.margin) + " apart";
                }
                // Else a test may pass too many.
                if (recording_->has_exact_tests()) {
                    ++row.wrong;
                    note("a test of an engine whose tests are exact passed volumes that are apart",
                         ", " + format("%.6g", test.margin) + " apart");
                }
            }
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

    void take_pairs(const EngineQuery& query, const QueryJudgement& judged, const QueryName& name,
                    FrameJudgement& row) {
        row.pairs += judged.reported;
        result_.exact_pairs += judged.exact;
        result_.not_looked_into += judged.not_looked_into;
        without_results_ += judged.without_results;
        broken_pairs_ += judged.broken;
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
        const std::string what = query.sides[0].mesh ? "triangle" : "object";
        std::string words = pair_words((what + "s").c_str(), problem.items.a, problem.items.b);
        const std::uint32_t item = problem.side == 0 ? problem.items.a : problem.items.b,
                            node = problem.side == 0 ? problem.nodes.a : problem.nodes.b;
        const std::string side = problem.side == 0 ? "A" : "B";
        const std::string of_node = "node " + std::to_string(node) + " of " + side;
        if (problem.cause == PairCause::in_no_leaf)
            words += "; no leaf of " + side + " has " + what + " " + std::to_string(item);
        if (problem.cause == PairCause::no_tree)
            words += "; the tree of " + side + " was recorded without nodes";
        if (problem.nodes.a != no_index && problem.nodes.b != no_index)
            words += "; at " + pair_words("nodes", problem.nodes.a, problem.nodes.b);
        if (problem.cause == PairCause::not_contained)
            words += ", of which " + of_node + " does not contain " + what + " " +
                     std::to_string(item) + ", by " + amount_words(problem.amount);
        if (problem.cause == PairCause::below_outside)
            words += "; " + of_node + " does not contain " + what + " " + std::to_string(item) +
                     ", by " + amount_words(problem.amount);
        if (problem.cause == PairCause::bad_volume)
            words += ", of which " + of_node + " has a volume that is none";
        if (problem.cause == PairCause::below_bad_volume)
            words += "; " + of_node + " has a volume that is none";
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

    void not_judged(std::uint64_t count, std::uint64_t of, const std::string& what,
                    const std::string& why) {
        if (count > 0) result_.not_judged.push_back({count, of, what, why});
    }

    void list_not_judged() {
        not_judged(hidden_, queries_, "queries", hidden_why_);
        not_judged(unplaced_, queries_, "queries", unplaced_why_);
        not_judged(result_.unknown_items, queries_, "queries, of which the pairs",
                   "objects share leaves, have numbers above 999,999, or were queried with "
                   "triangles");
        not_judged(without_result_, queries_, "queries", "they ended early without a pair");
        for (const auto& [number, watch] : watches_) {
            const UnjudgedVolumes& of = watch.unjudged();
            not_judged(of.leaves, of.of_leaves, "leaf volumes of " + tree_words(number),
                       "the extents of their objects were not recorded (scb_record_object)");
            not_judged(of.splits, of.of_splits, "triangles in several leaves of " + tree_words(number),
                       "the surfaces of these leaves run along each other");
            const TreeState& tree = recording_->trees().at(number);
            if (tree.tree.size() == 0) not_judged(1, watches_.size(), "trees", tree_words(number) + " was recorded without nodes");
        }
        not_judged(unjudged_tests_, tests_of_all_, "tests of volumes",
                   "a node has no volume, or one that is none");
        not_judged(lacks_, divided_, "divisions of nodes",
                   "a child that overlaps the other node was not tested; the first: " + lacking_ +
                       (lacks_alike_ && lacks_ > 1
                            ? "; in all of them child " + std::to_string(first_lack_.place + 1) +
                                  " of the node of " + (first_lack_.side == 0 ? "A" : "B")
                            : ""));
        std::uint64_t reported = 0;
        for (const FrameJudgement& row : result_.frames) reported += row.pairs;
        const std::uint64_t pairs = std::max(reported, result_.exact_pairs);
        not_judged(result_.grazing, std::max(pairs, result_.grazing), "pairs",
                   "they touch, or miss each other, by less than the tolerance");
        not_judged(result_.not_looked_into, pairs, "pairs",
                   "they were not reported, and of a query the first 100,000 are looked into");
        not_judged(broken_pairs_, reported, "pairs", "their triangles are not finite");
        not_judged(without_results_, without_results_, "pairs that intersect",
                   "the results of their queries were not recorded");
        if (recording_->unfinished_tree())
            not_judged(1, watches_.size(), "trees", "the file breaks off in " + tree_words(*recording_->unfinished_tree()));
        not_judged(recording_->unknown_records(), 0, "records",
                   "this version does not know their kind");
    }

    void list_costs() {
        if (repeated_ > 0)
            result_.costs.push_back({CostFinding::Kind::repeated, repeated_, tests_of_all_,
                                     first_repeated_, 0, 0});
        for (const TreeJudgement& tree : result_.trees) {
            const EngineSide side = recording_->side_of(tree.number);
            std::uint64_t leaves = 0;
            for (const std::uint32_t node : side.shape->order) leaves += side.shape->is_leaf(node);
            std::uint64_t enough = 0;
            while ((std::uint64_t{1} << enough) < leaves) ++enough;
            if (leaves >= 16 && tree.depth > 4 * enough)
                result_.costs.push_back({CostFinding::Kind::deep, tree.depth, enough,
                                         tree_words(tree.number), 0, 0});
        }
        for (auto& [number, finding] : loose_) {
            finding.tests = loose_tests_;
            finding.tests_if_tight = loose_tests_if_tight_;
            // Of a tree that does not contain its triangles, its size is the lesser problem.
            const bool is_wrong = watches_.at(number).most_outside() > 0;
            if (!is_wrong && 50 * finding.tests_if_tight < 49 * finding.tests)
                result_.costs.push_back(finding);
        }
    }

    void finish() {
        result_.poses = poses_.likely();
        if (poses_.lacks_poses() && result_.poses.empty())
            result_.notes.push_back(
                "no pose was told of the bodies of a query whose tests are wrong; tell those that "
                "the engine has, with scb_record_pose");
        for (const RecordedSetting& setting : recording_->settings())
            if (setting.key == "engine" && result_.engine.empty()) result_.engine = setting.value;
        for (const auto& [number, watch] : watches_) {
            const TreeState& tree = recording_->trees().at(number);
            TreeJudgement judged{number,
                                 tree.name,
                                 tree.tree.size(),
                                 0,
                                 0,
                                 0,
                                 recording_->unfinished_tree() == number,
                                 watch.problems(),
                                 fits_[number].fit,
                                 fits_[number].frame};
            const TreeShape& shape = *recording_->side_of(number).shape;
            for (const std::uint32_t i : shape.order)
                judged.depth = std::max(judged.depth, shape.depths[i]);
            judged.roots = shape.roots.size();
            judged.in_several_leaves = watch.unjudged().of_splits;
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
        list_not_judged();
        list_costs();
    }

    struct EarlierMesh {
        int version = 0, frame = 0;
        std::shared_ptr<const Mesh> mesh;
    };
    struct TreeFitting {
        std::optional<TreeFit> fit;
        std::size_t outside = 0;
        int tries = 0, frame = 0;
    };
    /// Known as long as the tree, which may be a stretched one, has this version.
    struct TightOfBody {
        const NodeTree* tree = nullptr;
        int version = -1;
        TightBoxes boxes;
    };
    struct SizeOfItems {
        const NodeTree* tree = nullptr;
        int version = -1;
        double size = 0;
    };

    RecordingJudgement result_;
    std::optional<RecordedQueries> recording_;
    OwnContacts own_;
    std::map<std::uint32_t, TreeWatch> watches_;
    std::map<std::uint32_t, std::deque<EarlierMesh>> earlier_;  ///< by mesh
    std::map<std::uint32_t, TreeFitting> fits_;                 ///< by tree
    std::map<std::uint8_t, StageJudgement> stages_;
    Groups missed_, false_, tests_;
    PoseSearch poses_;
    bool moves_noted_ = false;
    // What was not judged, and why.
    std::uint64_t queries_ = 0, hidden_ = 0, unplaced_ = 0, without_result_ = 0,
                  without_results_ = 0, broken_pairs_ = 0, unjudged_tests_ = 0, tests_of_all_ = 0;
    std::string hidden_why_, unplaced_why_;
    std::map<std::uint32_t, SizeOfItems> sizes_;  ///< by body
    std::set<std::uint32_t> stretched_;           ///< bodies of which that was noted
    // What costs.
    std::uint64_t repeated_ = 0, loose_tests_ = 0, loose_tests_if_tight_ = 0;
    std::string first_repeated_;
    std::map<std::uint32_t, CostFinding> loose_;  ///< by tree
    std::map<std::uint32_t, TightOfBody> tight_;  ///< by body
    std::uint64_t divided_ = 0, lacks_ = 0;  ///< see DivisionCounts
    DivisionCounts::Lack first_lack_;
    std::string lacking_;  ///< which that is
    bool lacks_alike_ = true;
    /// Of two bodies the frame of the last query, and its pose.
    std::map<std::array<std::uint32_t, 2>, std::pair<int, Pose>> last_queries_;
};

}  // namespace

Verdict RecordingJudgement::verdict() const {
    const bool tree = std::any_of(trees.begin(), trees.end(), [](const TreeJudgement& judged) {
        return !judged.problems.empty();
    });
    if (tree || !missed.empty() || !false_pairs.empty() || !test_problems.empty() ||
        !poses.empty() || !odd.empty())
        return Verdict::wrong;
    return not_judged.empty() && damage.empty() ? Verdict::sound : Verdict::partly_judged;
}

RecordingJudgement judge_recording(std::string_view bytes, std::string_view name,
                                   const std::function<bool(int)>& wanted,
                                   const std::function<bool(bool)>& done) {
    return RecordingJudge(bytes, name).judged(wanted, done);
}

}  // namespace scb::scenes
