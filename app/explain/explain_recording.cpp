#include "app/explain/explain_recording.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "app/explain/explain_pictures.h"
#include "app/explain/explain_report.h"
#include "app/study/query_source.h"
#include "app/study/recorded_pair.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/model/tree.h"
#include "core/platform/utf8.h"
#include "render/figures/figure_words.h"
#include "scb/error.h"
#include "scb/triangle_overlap.h"
#include "scenes/recordings/recorded_trace.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;
using scenes::RecordedTrace;

/// The trace at the frame in the options. Without --frames, RecordedTrace::frame_of_test chooses
/// the frame.
std::unique_ptr<RecordedTrace> open_trace(const ExplainOptions& options, IndexPair numbers) {
    const std::string& path = options.scene.names[0];
    const auto open = [&](const std::string& frames) {
        return std::make_unique<RecordedTrace>(path, options.query.bodies, frames,
                                               options.scene.selection);
    };
    if (!options.scene.frames.empty()) {
        std::unique_ptr<RecordedTrace> trace = open(options.scene.frames);
        if (trace->frames().size() != 1)
            throw InputError("--frames " + options.scene.frames +
                             ": this command takes one frame; give one.");
        return trace;
    }
    const std::unique_ptr<RecordedTrace> trace = open(auto_frames);
    return open(std::to_string(trace->frame_of_test(numbers, trace->frames()[0])));
}

std::uint32_t checked_number(std::int64_t number, const std::string& option) {
    if (number < 0 || number >= std::int64_t{no_index})
        throw InputError(option + ": " + std::to_string(number) +
                         " is no number of a node; give numbers from 0 to " +
                         std::to_string(no_index - 1) + ".");
    return static_cast<std::uint32_t>(number);
}

/// "rejected at box", "passed": the recorded outcome.
std::string ending_of(const RecordedPair& found, Stage stage) {
    return stage == Stage::overlapping ? "passed"
                                       : "rejected at " + stage_words(found.header(), stage);
}

IndexPair numbers_of_test(const RecordedPair& found, std::size_t test) {
    return numbers_of(*found.frame, found.frame->steps.volumes[test].nodes);
}

std::string test_text(const RecordedPair& found, const FoundTest& test) {
    std::string text = ending_of(found, test.stage) +
                       format(", test %zu of %zu", test.number, found.frame->steps.volumes.size());
    if (!test.led_by) return text;
    const IndexPair nodes = numbers_of_test(found, *test.led_by);
    return text +
           format(", which test %zu of the nodes (%u, %u) led to", *test.led_by, nodes.a, nodes.b);
}

/// The end of A and the beginning of B along the direction that separates them.
struct Extents {
    double end_of_a = 0, start_of_b = 0;

    explicit Extents(const RecordedPair& found) {
        const OverlapStep& step = found.pair.found.steps.steps[0];
        end_of_a = dot(step.direction, center(found.pair.a)) + step.reach_a;
        start_of_b = dot(step.direction, center(b_seen_from_a(found.pair))) - step.reach_b;
    }
};

std::string verdict_text(const RecordedPair& found) {
    const ContactCertificate& certificate = found.pair.found.certificate;
    if (!found.has_verdict) return "not judged: there is no exact test of volumes of these types";
    if (certificate.contact == Contact::touching)
        return "touching: neither apart nor in each other by more than " +
               format("%.6g", found.pair.placed.margin) + ", the engine's tolerance";
    if (certificate.contact == Contact::overlapping) return exact_text(found.pair);
    const Extents extents(found);
    return exact_text(found.pair) + "\n" + std::string(12, ' ') +
           format("along it, A ends at %.6g and B begins at %.6g", extents.end_of_a,
                  extents.start_of_b);
}

std::string report_text(const RecordedPair& found, bool colored) {
    constexpr std::size_t most = 10;
    std::string text = volumes_text(found.pair) + "\n";
    const auto row = [&text](const std::string& name, const std::string& value) {
        text += format("  %-10s", name.c_str()) + value + "\n";
    };
    for (std::size_t i = 0; i < std::min(found.tests.size(), most); ++i)
        row(i == 0 ? "engine" : "again", test_text(found, found.tests[i]));
    if (found.tests.size() > most) row("", format("and %zu times more", found.tests.size() - most));
    if (found.tests.empty()) row("engine", "it recorded no test of these two nodes in this query");
    row("exact", verdict_text(found));
    if (!found.has_verdict) return text;
    std::vector<Answer> told;  // each once
    for (const FoundTest& test : found.tests)
        if (std::find(told.begin(), told.end(), test.answer) == told.end()) {
            told.push_back(test.answer);
            row("answer", answer_text(test.answer, colored));
        }
    return text;
}

Json report_json(const RecordedPair& found) {
    const scenes::Scene& scene = found.trace->scene();
    Json json = {{"scene", scene.name},
                 {"frame", found.frame->frame},
                 {"engine", found.header().engine->name}};
    const EngineQuery& query = found.trace->query();
    for (std::size_t side = 0; side < 2; ++side) {
        const ExplainedNode& node = (*found.pair.nodes)[side];
        const EngineNodes& tree = *query.sides[side].tree;
        const std::uint32_t index = side == 0 ? found.nodes.a : found.nodes.b;
        Json entry = {{"body", node.body},
                      {"index", node.index},
                      {"depth", node.depth},
                      {node.are_objects ? "objects" : "triangles", node.triangles},
                      {"volume", volume_title(tree[index].volume)},
                      {"told_at", tree[index].recorded_at}};
        if (const std::string name = tree.name_of(index); !name.empty()) entry["name"] = name;
        json["nodes"].push_back(std::move(entry));
    }
    json["tests"] = Json::array();
    for (const FoundTest& test : found.tests) {
        Json entry = {{"test", test.number},
                      {"stage", stage_words(found.header(), test.stage)},
                      {"answer", found.has_verdict ? Json(answer_names[test.answer]) : Json()}};
        if (test.led_by) {
            const IndexPair nodes = numbers_of_test(found, *test.led_by);
            entry["led_by"] = {{"test", *test.led_by}, {"nodes", {nodes.a, nodes.b}}};
        }
        json["tests"].push_back(std::move(entry));
    }
    const ContactCertificate& certificate = found.pair.found.certificate;
    json["exact"] = found.has_verdict ? Json(contact_names[certificate.contact]) : Json();
    json["certificate"] = certificate_json(found.pair);
    if (certificate.contact == Contact::disjoint) {
        const Extents extents(found);
        json["certificate"]["end_of_a"] = extents.end_of_a;
        json["certificate"]["start_of_b"] = extents.start_of_b;
    }
    json["tolerance"] = found.pair.placed.margin;
    add_volumes_json(json, found.pair);
    return json;
}

ExplainPicture picture_of(const RecordedPair& found, const ExplainOptions& options) {
    const TraceHeader& header = found.header();
    const int frame = found.frame->frame;
    ExplainPicture picture;
    NamedOptions named;
    name_view(named, options.picture, options.camera);
    name_picture(named, options.picture);
    const auto& [a, b] = *found.pair.nodes;
    picture.name = options.picture.picture_stem(explain_name(
        options.scene.file_stem(header.scene), header, named, frame, {a.index, b.index}));
    place_nodes(picture, {found.trace->body(0, frame), found.trace->body(1, frame)}, found.nodes);
    const PairNames names = pair_names(header.scene, found.pair);
    picture.title = (names.scene.empty() ? "" : names.scene + " · ") +
                    render::volume_title(header) + " · explain · " + names.nodes;
    picture.subtitle = format("frame %d", frame);
    picture.is_tested = !found.tests.empty() && found.has_verdict;
    picture.ending =
        printable(header.engine->name) + ":  " +
        (found.tests.empty() ? "no test was recorded" : ending_of(found, found.tests[0].stage));
    picture.camera = asked_camera(options.camera, &found.trace->scene());
    picture.orthographic = options.camera.orthographic;
    return picture;
}

}  // namespace

int explain_recording(const ExplainOptions& options, const Console& console) {
    const std::string option = "--pair " + options.pair;
    const auto [i, j] = options.nodes();
    const IndexPair numbers{checked_number(i, option), checked_number(j, option)};
    const std::unique_ptr<RecordedTrace> trace = open_trace(options, numbers);
    refuse_recorded_distances(trace->header());
    note_left_out(*trace, console.notes());
    const RecordedPair found = recorded_pair(*trace, trace->frames()[0], numbers, option);
    const std::string title = printable(found.header().scene) + ", " +
                              printable(found.header().engine->name) + ", frame " +
                              std::to_string(found.frame->frame) + ": " +
                              printable(node_names(found.pair)) + "\n",
                      text = title + report_text(found, console.colors_results());
    Json entry = report_json(found);
    const int status = found.has_wrong_test() ? exit_different : exit_done;
    if (status != exit_done) console.alarm("scb: the test rejected volumes that overlap.");
    if (!options.draws()) {
        print_result(options.picture.json ? json_text(Json::array({entry}), 2) + "\n" : text);
        return status;
    }
    PictureRun pictures(options.picture, found.header().scene);
    const ExplainPicture picture = picture_of(found, options);
    draw_explanation(pictures, options.picture, found.pair, picture, entry);
    pictures.say(text);
    entry["file"] = picture.name + ".png";
    if (options.picture.json) pictures.print_instead(json_text(Json::array({entry}), 2) + "\n");
    pictures.finish(explain_index_head(options), console);
    return status;
}

}  // namespace scb::app
