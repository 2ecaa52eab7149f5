#include "app/query/trace_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/console.h"
#include "core/analysis/trace_words.h"
#include "core/base/text_format.h"
#include "core/collide/index_pairs.h"
#include "core/platform/utf8.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

// Prints the text once it is long enough, and clears it.
void print_block(std::string& text) {
    constexpr std::size_t block = std::size_t{1} << 16;
    if (text.size() < block) return;
    print_result(text);
    text.clear();
}

/// The width of node columns: engines may have large numbers.
int number_width(const TraceFrame& frame) {
    std::uint32_t most = 0;
    for (const std::shared_ptr<const Tree>& tree : frame.trees)
        for (std::uint32_t node = 0; tree && node < tree->size(); ++node)
            most = std::max(most, tree->number(node));
    return std::max(8, static_cast<int>(std::to_string(most).size()));
}

}  // namespace

std::string trace_header_text(const TraceHeader& header) {
    std::string text;
    for (const TraceField& field : fields_of(header))
        text += format("%-10s ", field.name.c_str()) + printable(field.value) + "\n";
    std::string files;
    for (const std::string& name : header.source) files += (files.empty() ? "" : " ") + name;
    text += format("%-10s ", "named") + printable(files) + "\n";
    if (header.engine) return text;
    return text + "recorded by scb " + printable(header.scb_version) + "\n";
}

Json body_json(const TraceBody& body) {
    return {{"name", body.name},
            {"triangles", body.mesh.triangles},
            {"vertices", body.mesh.vertices},
            {"hash", hash_text(body.mesh.hash)}};
}

Json trace_header_json(const TraceHeader& header) {
    Json bodies = Json::array();
    for (const TraceBody& body : header.bodies) bodies.push_back(body_json(body));
    Json result;
    if (!header.engine) result["version"] = header.scb_version;
    result["source"] = header.source;
    result["scene"] = header.scene;
    result["bodies"] = bodies;
    if (header.engine) {
        result["engine"] = header.engine->name;
        result["volume"] = header.engine->volumes;
        result["settings"] = Json::object();
        for (const TraceField& setting : header.engine->settings)
            result["settings"][setting.name] = setting.value;
        return result;
    }
    result["volume"] = volume_kind_name(header.volume);
    result["growth"] = ball_growth_name(header.growth);
    result["margin"] = header.margin;
    result["split"] = split_method_name(header.split);
    if (header.volume == VolumeKind::scb) {
        result["test"] = overlap_test_name(header.options.overlap.test);
        if (has_threshold(header.options.overlap.test))
            result["threshold"] = header.options.overlap.threshold;
    }
    result["descent"] = descent_rule_name(header.options.descent);
    result["max_pairs"] = header.options.max_pairs;
    result["level"] = header.options.stop_level >= 0 ? Json(header.options.stop_level) : Json();
    return result;
}

Json traced_test_json(const TracedTest& test, const BodyNames& bodies) {
    const auto nodes = [](const Step& t) -> Json {
        return {{"nodes", {t.nodes.a, t.nodes.b}}, {"depths", {t.depth_a, t.depth_b}}};
    };
    Json result = nodes(test.test);
    result["stage"] = test.stage;
    result["outcome"] = words_of(test, bodies);
    if (test.triangles) {
        result["triangles"] = {test.triangles->items.a, test.triangles->items.b};
        result["intersect"] = test.triangles->hit;
        if (test.triangle_tests > 1) {
            result["triangle_tests"] = test.triangle_tests;
            result["intersecting"] = test.intersecting;
        }
    }
    if (test.parent) {
        result["parent"] = nodes(*test.parent);
        result["parent"]["divided"] = test.parent_outcome == Stage::divided_both
                                          ? "both"
                                          : bodies[test.parent_outcome == Stage::divided_a ? 0 : 1];
    }
    return result;
}

void print_events(const TraceHeader& header, const TraceFrame& frame) {
    const Outcomes outcomes = outcomes_of(header, frame);
    const BodyNames names = side_names(header), bodies = {printable(names[0]), printable(names[1])};
    const int width = number_width(frame);
    std::string text =
        format("   test  parent %*s %*s  depths  outcome\n", width, "node A", width, "node B");
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const TracedTest test = traced_test(header, frame, outcomes, i);
        const std::string parent =
            test.test.parent == no_step ? "-" : std::to_string(test.test.parent);
        text += format("%7zu %7s %*u %*u %3d %3d  ", i, parent.c_str(), width, test.test.nodes.a,
                       width, test.test.nodes.b, test.test.depth_a, test.test.depth_b) +
                words_of(test, bodies) + "\n";
        print_block(text);
    }
    print_result(text);
}

void print_events_json(const TraceHeader& header, const TraceFrame& frame,
                       const std::string& indent) {
    const Outcomes outcomes = outcomes_of(header, frame);
    const BodyNames bodies = side_names(header);
    std::string text;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        Json row = {{"test", i}};
        const std::uint32_t parent = frame.steps.volumes[i].parent;
        row["parent_test"] = parent == no_step ? Json() : Json(parent);
        row.update(traced_test_json(traced_test(header, frame, outcomes, i), bodies));
        text += (i == 0 ? "\n" : ",\n") + indent +
                row.dump(-1, ' ', false, Json::error_handler_t::replace);
        print_block(text);
    }
    print_result(text);
}

}  // namespace scb::app
