#include "app/study/recorded_pair.h"

#include "core/base/text_format.h"
#include "core/judge/node_explanation.h"
#include "scb/error.h"

namespace scb::app {
namespace {

using scenes::RecordedTrace;

std::uint32_t checked_node(const BodyAtFrame& body, const EngineNodes& tree, std::uint32_t number,
                           int frame, const std::string& option) {
    const std::uint32_t node = tree.index_of(number);
    const std::string start = option + ": at frame " + std::to_string(frame) + " ";
    if (node == no_index) {
        std::uint32_t least = no_index, most = 0;
        for (std::size_t i = 0; i < tree.size(); ++i) {
            least = std::min(least, tree[i].number);
            most = std::max(most, tree[i].number);
        }
        throw InputError(
            start + "the tree of " + body.name + " has no node " + std::to_string(number) +
            (tree.size() == 0
                 ? std::string("; it has none.")
                 : format("; it has %zu, with numbers from %u to %u.", tree.size(), least, most)));
    }
    if (!has_volume(tree[node].volume)) {
        const std::string fault = tree.volume_fault(node);
        throw InputError(start + tree.words(node) + " of " + body.name + " has no volume" +
                         (fault.empty() ? std::string(" in the recording")
                                        : " that could be judged (" + fault + ")") +
                         "; name nodes with volumes.");
    }
    return node;
}

ExplainedNode described(const BodyAtFrame& body, const EngineSide& side, std::uint32_t node) {
    const EngineNode& told = (*side.tree)[node];
    ExplainedNode result{body.name, told.number, 0, items_below(*side.shape)[node]};
    result.are_objects = side.mesh == nullptr;
    if (side.shape->is_reachable(node)) result.depth = static_cast<int>(side.shape->depths[node]);
    const std::string name = side.tree->name_of(node);
    result.remark = (name.empty() ? "" : "'" + name + "', ") + volume_title(told.volume) +
                    format(" recorded at frame %d", told.recorded_at);
    return result;
}

}  // namespace

RecordedPair recorded_pair(RecordedTrace& trace, int number, IndexPair numbers,
                           const std::string& option) {
    RecordedPair found;
    found.trace = &trace;
    found.frame = &trace.frame(number);
    const EngineQuery& query = trace.query();
    const auto& [a, b] = query.sides;
    const BodyAtFrame &body_a = trace.body(0, number), &body_b = trace.body(1, number);
    found.nodes = {checked_node(body_a, *a.tree, numbers.a, number, option),
                   checked_node(body_b, *b.tree, numbers.b, number, option)};
    const NodeVolume &of_a = (*a.tree)[found.nodes.a].volume,
                     &of_b = (*b.tree)[found.nodes.b].volume;
    const std::vector<Step>& tests = found.frame->steps.volumes;
    for (std::size_t i = 0; i < tests.size(); ++i) {
        if (tests[i].nodes != found.nodes) continue;
        found.tests.push_back({i, tests[i].stage, std::nullopt});
        if (tests[i].parent != no_step) found.tests.back().led_by = tests[i].parent;
    }
    const Stage ended = found.tests.empty() ? Stage::overlapping : found.tests[0].stage;
    Placement placed;
    placed.b_to_a = query.b_to_a;
    placed.margin = tolerance_of(query, found.nodes);
    // Any convex kind, so that pictures have the symbols of general volumes.
    found.pair = {VolumeKind::capsule,
                  body_a.tree->volume(found.nodes.a),
                  body_b.tree->volume(found.nodes.b),
                  placed,
                  {},
                  explain_nodes(of_a, of_b, query.b_to_a, placed.margin, ended),
                  {},
                  {{described(body_a, a, found.nodes.a), described(body_b, b, found.nodes.b)}}};
    found.has_verdict = proven_verdict(of_a, of_b, query.b_to_a, placed.margin).has_value();
    for (FoundTest& test : found.tests)
        test.answer = judged(test.stage, found.pair.found.certificate.contact);
    return found;
}

}  // namespace scb::app
