#include "scenes/recordings/test_findings.h"

#include <algorithm>
#include <cmath>

#include "core/base/text_format.h"
#include "core/judge/node_explanation.h"

namespace scb::scenes {
namespace {

/// Whether a test names a node that its tree does not have. Trees without nodes are not checked.
bool names_unknown_node(const EngineQuery& query, IndexPair nodes) {
    return (nodes.a == no_index && query.sides[0].tree->size() > 0) ||
           (nodes.b == no_index && query.sides[1].tree->size() > 0);
}

/// The margin that `scb explain` proves for the volumes of a judged test: close to their gap or
/// depth, where the margin of the verdict may be much smaller.
double sharp_margin(const EngineQuery& query, const JudgedTest& test) {
    const auto volume = [&](std::size_t side, std::uint32_t node) -> const NodeVolume& {
        return (*query.sides[side].tree)[node].volume;
    };
    const PairExplanation found =
        explain_nodes(volume(0, test.nodes.a), volume(1, test.nodes.b), query.b_to_a,
                      tolerance_of(query, test.nodes), Stage::overlapping);
    return found.verified ? std::max(test.margin, found.certificate.margin) : test.margin;
}

std::string apart_words(double margin) { return format("%.6g", margin) + " apart"; }
std::string depth_words(double margin) { return format("%.6g", margin) + " deep in each other"; }

}  // namespace

void add_case(ProblemGroups& groups, const std::string& what, ProblemCase one) {
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&what](const ProblemGroup& g) { return g.what == what; });
    if (group == groups.end()) group = groups.insert(group, ProblemGroup{what, 0, {}});
    ++group->count;
    if (group->cases.size() < ProblemGroup::most_cases) group->cases.push_back(std::move(one));
}

bool have_volumes(const EngineQuery& query, IndexPair numbers) {
    const auto has = [](const EngineNodes& tree, std::uint32_t number) {
        const std::uint32_t node = tree.index_of(number);
        return node != no_index && has_volume(tree[node].volume);
    };
    return has(*query.sides[0].tree, numbers.a) && has(*query.sides[1].tree, numbers.b);
}

ProblemGroups by_count(ProblemGroups groups) {
    std::stable_sort(
        groups.begin(), groups.end(),
        [](const ProblemGroup& a, const ProblemGroup& b) { return a.count > b.count; });
    return groups;
}

void TestFindings::take(const RecordedQueries& recording, const EngineQuery& query,
                        const QueryJudgement& judged, const QueryName& name, FrameJudgement& row) {
    for (std::uint32_t number = 0; number < judged.tests.size(); ++number)
        take_volumes(recording, query, judged, number, name, row);
    row.item_tests += judged.item_tests;
    row.wrong += judged.wrong_item_tests.size() + judged.stray_item_tests.size();
    for (const WrongItemTest& test : judged.wrong_item_tests) take_items(query, test, name);
    for (const WrongItemTest& stray : judged.stray_item_tests) {
        const EngineEvent& event = query.events[stray.event];
        add("a test of triangles that are not in the leaves that were tested before",
            {name,
             pair_words("triangles", event.a, event.b) + test_words(stray.test) +
                 "; are these their numbers?",
             {no_index, no_index},
             {event.a, event.b},
             stray.test});
    }
    take_divisions(query, judged, name);
}

void TestFindings::take_volumes(const RecordedQueries& recording, const EngineQuery& query,
                                const QueryJudgement& judged, std::uint32_t number,
                                const QueryName& name, FrameJudgement& row) {
    const JudgedTest& test = judged.tests[number];
    const EngineEvent& event = query.events[test.event];
    StageJudgement& stage = stages_[event.stage];
    ++stage.tests;
    ++row.volume_tests;
    ++tests_;
    const bool is_unknown = names_unknown_node(query, test.nodes);
    unjudged_ += test.verdict == TestVerdict::unjudged && !is_unknown;
    const auto words = [&] { return pair_words("nodes", event.a, event.b) + test_words(number); };
    const auto note = [&](const std::string& what, const std::string& more = {}) {
        const IndexPair nodes{event.a, event.b};
        add(what, {name,
                   words() + more,
                   nodes,
                   {no_index, no_index},
                   number,
                   have_volumes(query, nodes)});
    };
    if (is_unknown) note("a test of a node that its tree does not have");
    if (test.repeated && repeated_++ == 0) first_repeated_ = query_words(name) + ": " + words();
    if (test.verdict == TestVerdict::false_positive) {
        ++stage.false_positives;
        if (test.margin > stage.most_apart) {
            stage.most_apart = test.margin;
            stage.farthest = query_words(name) + ": " + words() + ", " + apart_words(test.margin);
        }
        // Tests of other engines may pass disjoint volumes.
        if (recording.has_exact_tests() && !is_of_distance(query)) {
            ++row.wrong;
            note("a test of an engine whose tests are exact passed volumes that are apart",
                 ", " + apart_words(test.margin));
        }
    }
    if (test.verdict != TestVerdict::wrong) return;
    ++row.wrong;
    // The search takes up to a millisecond, so only listed cases and candidates for the least depth
    // have it, and not too many. Another margin may be far below the depth, but is a bound of it.
    constexpr std::size_t most_searches = 1000;
    const bool is_listed = stage.wrong < ProblemGroup::most_cases;
    const bool is_sharp =
        searches_ < most_searches && (is_listed || test.margin < stage.least_depth);
    searches_ += is_sharp;
    const bool measures = is_of_distance(query);
    const double depth = is_sharp && !measures ? sharp_margin(query, test) : test.margin;
    stage.least_depth = stage.wrong == 0 ? depth : std::min(stage.least_depth, depth);
    stage.most_depth = std::max(stage.most_depth, depth);
    ++stage.wrong;
    if (measures) return;  // see DistanceFindings
    note("a test that rejected volumes which overlap, at stage \"" +
             stage_words(recording.stages(), event.stage) + "\"",
         ", " + depth_words(depth));
}

void TestFindings::take_items(const EngineQuery& query, const WrongItemTest& test,
                              const QueryName& name) {
    const EngineEvent& event = query.events[test.event];
    const std::string what = query.sides[0].mesh ? "triangles" : "objects";
    const std::string words = pair_words(what, event.a, event.b) + test_words(test.test);
    if (test.unknown)
        return add(query.sides[0].mesh ? "a test of a triangle that its mesh does not have"
                                       : "a test of an object that its tree does not have",
                   {name, words, {no_index, no_index}, {no_index, no_index}, test.test});
    if (is_of_distance(query) && !event.has_length)
        return add("a test of two triangles is wrong about whether they are within the tolerance",
                   {name,
                    words + ", by " + amount_words(test.margin),
                    {no_index, no_index},
                    {event.a, event.b},
                    test.test});
    if (is_of_distance(query))
        return add("a measured distance of two triangles is wrong",
                   {name,
                    words + format(", %.9g", event.length) +
                        (std::isinf(test.margin) ? std::string()
                                                 : ", wrong by " + amount_words(test.margin)),
                    {no_index, no_index},
                    {event.a, event.b},
                    test.test});
    const bool meet = event.kind == EngineEvent::Kind::items_meet;
    add(meet ? "a test said that two " + what + " meet which do not"
             : "a test said that two " + what + " are apart which intersect",
        {name,
         words + ", " + (meet ? apart_words(test.margin) : depth_words(test.margin)) +
             (test.strayed ? "; the nodes that have them were not tested before, so are these "
                             "their numbers?"
                           : ""),
         {no_index, no_index},
         {event.a, event.b},
         test.test});
}

void TestFindings::take_divisions(const EngineQuery& query, const QueryJudgement& judged,
                                  const QueryName& name) {
    const DivisionCounts& here = judged.divisions;
    if (here.lacking > 0 && lacking_.empty()) {
        const JudgedTest& test = judged.tests[here.first.test];
        lacking_ = query_words(name) + ": " +
                   pair_words("nodes", (*query.sides[0].tree)[test.nodes.a].number,
                              (*query.sides[1].tree)[test.nodes.b].number) +
                   test_words(here.first.test) + ", where node " +
                   std::to_string(here.first.child) + " of " + (here.first.side == 0 ? "A" : "B") +
                   " was not tested";
        first_lack_ = here.first;
    }
    if (here.lacking > 0)
        lacks_alike_ = lacks_alike_ && here.alike && here.first.side == first_lack_.side &&
                       here.first.place == first_lack_.place;
    divided_ += here.divided;
    lacks_ += here.lacking;
}

std::vector<StageJudgement> TestFindings::stages(const StageNames& names) const {
    std::map<std::uint8_t, StageJudgement> all = stages_;
    for (const auto& [stage, name] : names) all[stage].name = name;
    std::vector<StageJudgement> result;
    for (auto& [stage, judged] : all) {
        judged.name = stage_words(names, stage);
        result.push_back(judged);
    }
    return result;
}

std::optional<CostFinding> TestFindings::repeated() const {
    if (repeated_ == 0) return std::nullopt;
    return CostFinding{CostFinding::Kind::repeated, repeated_, tests_, first_repeated_, 0, 0};
}

void TestFindings::list_not_judged(std::vector<NotJudged>& parts) const {
    if (unjudged_ > 0)
        parts.push_back({unjudged_, tests_, "tests of volumes",
                         "a node has no volume, one that is smaller than the tolerance, or one of "
                         "a kind that has no exact test"});
    if (lacks_ > 0)
        parts.push_back(
            {lacks_, divided_, "divisions of nodes",
             "a child that overlaps the other node was not tested, and the recording does not show "
             "whether this is intended; the first: " +
                 lacking_ +
                 (lacks_alike_ && lacks_ > 1
                      ? "; in all of them child " + std::to_string(first_lack_.place + 1) +
                            " of the node of " + (first_lack_.side == 0 ? "A" : "B")
                      : "")});
}

}  // namespace scb::scenes
