#include "app/trace_report.h"

#include <cstdio>

#include "core/trace_words.h"

namespace scb {
namespace {

using Json = nlohmann::ordered_json;

template <class... Values>
std::string format(const char* pattern, Values... values) {
    char text[160];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

}  // namespace

std::string trace_header_text(const TraceHeader& header) {
    std::string text;
    for (const TraceField& field : fields_of(header))
        text += format("%-10s ", field.name.c_str()) + field.value + "\n";
    return text + "recorded by scb " + header.scb_version + "\n";
}

Json trace_header_json(const TraceHeader& header) {
    Json bodies = Json::array();
    for (const TraceBody& body : header.bodies)
        bodies.push_back(
            {{"name", body.name},
             {"triangles", body.mesh.triangles},
             {"vertices", body.mesh.vertices},
             {"hash", format("%016llx", static_cast<unsigned long long>(body.mesh.hash))}});
    Json result = {{"version", header.scb_version},
                   {"source", header.source},
                   {"scene", header.scene},
                   {"bodies", bodies},
                   {"volume", volume_kind_name(header.volume)},
                   {"growth", header.growth == BallGrowth::ritter ? "ritter" : "radius"},
                   {"margin", header.margin}};
    if (header.volume == VolumeKind::scb) {
        result["test"] = overlap_test_name(header.options.overlap.test);
        if (has_threshold(header.options.overlap.test))
            result["threshold"] = header.options.overlap.threshold;
    }
    result["descent"] = descent_rule_name(header.options.descent);
    result["max_pairs"] = header.options.max_pairs;
    if (header.options.stop_level >= 0) result["level"] = header.options.stop_level;
    return result;
}

Json traced_test_json(const TracedTest& test) {
    const auto nodes = [](const VolumeTest& t) -> Json {
        return {{"nodes", {t.nodes.a, t.nodes.b}}, {"depths", {t.depth_a, t.depth_b}}};
    };
    Json result = nodes(test.test);
    result["stage"] = stage_name(test.test.stage);
    result["outcome"] = words_of(test);
    if (test.triangles) {
        result["triangles"] = {test.triangles->triangles.a, test.triangles->triangles.b};
        result["intersect"] = test.triangles->intersect;
    }
    if (test.parent) {
        result["parent"] = nodes(*test.parent);
        result["parent"]["divided"] = test.parent_outcome == Outcome::divided_a ? "A" : "B";
    }
    return result;
}

std::string trace_events_text(const TraceHeader& header, const TraceFrame& frame) {
    const TestTree tree = test_tree(header, frame);
    std::string text = "   test  parent   node A   node B  depths  outcome\n";
    for (std::size_t i = 0; i < tree.outcomes.size(); ++i) {
        const TracedTest test = traced_test(frame, tree, i);
        const std::string parent =
            tree.parents[i] == TestTree::no_parent ? "-" : std::to_string(tree.parents[i]);
        text += format("%7zu %7s %8u %8u %3d %3d  ", i, parent.c_str(), test.test.nodes.a,
                       test.test.nodes.b, test.test.depth_a, test.test.depth_b) +
                words_of(test) + "\n";
    }
    return text;
}

Json trace_events_json(const TraceHeader& header, const TraceFrame& frame) {
    const TestTree tree = test_tree(header, frame);
    Json list = Json::array();
    for (std::size_t i = 0; i < tree.outcomes.size(); ++i)
        list.push_back(traced_test_json(traced_test(frame, tree, i)));
    return list;
}

}  // namespace scb
