#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/explain/explain_pictures.h"
#include "app/explain/explain_recording.h"
#include "app/explain/explain_report.h"
#include "app/explain/explain_volumes.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "render/figures/figure_words.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// A scene or a trace of one, at a frame.
struct SceneAtFrame {
    QuerySource source;
    int frame;
};

SceneAtFrame open_scene(const ExplainOptions& options) {
    QueryOptions query = options.query;
    const std::string& name = options.scene.names[0];
    const bool trace = options.scene.names.size() == 1 && scenes::names_trace(name);
    if (trace) refuse_for_trace(options.recording, name);
    if (trace && !options.scene.frames.empty()) query.frames = options.scene.frames;
    QuerySource source(options.scene, options.hierarchy, query, {}, false);
    source.refuse_distances();
    const int frame = trace ? source.frames()[0] : options.scene.frame_of(source.query().scene);
    if (trace) source.frame(frame);  // throws if bodies have moved since the recording
    return {std::move(source), frame};
}

int explain_scene(const ExplainOptions& options, const Console& console) {
    const SceneAtFrame at = open_scene(options);
    const SceneQuery& query = at.source.query();
    const scenes::Scene& scene = query.scene;
    note_doubts(options.hierarchy, {query.kind}, console.notes());
    note_doubts(options.scene, query.scene, options.query, {query.kind}, console.notes());
    const ExplainedPair pair =
        explained_nodes(query, at.frame, options.nodes(), "--pair " + options.pair);
    const int status = pair.found.answer == Answer::false_negative ? exit_different : exit_done;
    if (status != exit_done) console.alarm("scb: the test rejected volumes that overlap.");
    Json entry = {{"scene", scene.name}, {"frame", at.frame}};
    entry.update(explanation_json(pair));
    const std::string title = printable(scene.name) + ", frame " + std::to_string(at.frame) + ": " +
                              printable(node_names(pair)) + "\n",
                      text = title + explanation_text(pair, console.colors_results());
    if (!options.draws()) {
        print_result(options.picture.json ? json_text(Json::array({entry}), 2) + "\n" : text);
        return status;
    }
    PictureRun pictures(options.picture, scene.name);
    ExplainPicture picture;
    const auto& [a, b] = *pair.nodes;
    NamedOptions named;
    name_query(named, at.source, at.source);
    name_view(named, options.picture, options.camera);
    name_picture(named, options.picture);
    picture.name = options.picture.picture_stem(explain_name(options.scene.file_stem(scene.name),
                                                             at.source.header(), named, at.frame,
                                                             {a.index, b.index}));
    const PairNames names = pair_names(scene.name, pair);
    picture.title = (names.scene.empty() ? "" : names.scene + " · ") +
                    std::string(render::volume_title(query.kind)) + " · explain · " + names.nodes;
    picture.subtitle = asked_words(pair);
    if (scene.frames > 1)
        picture.subtitle += (picture.subtitle.empty() ? "" : ", ") + format("frame %d", at.frame);
    place_nodes(picture, {at.source.body(0, at.frame), at.source.body(1, at.frame)},
                {a.index, b.index});
    picture.camera = asked_camera(options.camera, &scene);
    picture.orthographic = options.camera.orthographic;
    draw_explanation(pictures, options.picture, pair, picture, entry);
    pictures.say(text);
    entry["file"] = picture.name + ".png";
    if (options.picture.json) pictures.print_instead(json_text(Json::array({entry}), 2) + "\n");
    pictures.finish(explain_index_head(options), console);
    return status;
}

int run(const ExplainOptions& options, const Console& console) {
    options.check();
    if (!options.pairs_file.empty()) return explain_volumes(options, console);
    return options.scene.is_recording() && asks_for_recorded(options.recording)
               ? explain_recording(options, console)
               : explain_scene(options, console);
}

}  // namespace

void add_explain(const Command& program, const Console& console, Action& action) {
    const Command command = program.add_subcommand(
        "explain", "Explain one overlap test of two volumes step by step, and judge it");
    const auto options = std::make_shared<ExplainOptions>();
    add_explain_options(command, *options);
    command.footer(
        "The slack of a step says by how much the step separates the volumes; it is positive if it "
        "does. The first step that\n"
        "separates decides. Below are the exact answer with its certificate, and the answers of "
        "the other tests. Exit status 1\n"
        "if the test rejected volumes that overlap.\n\n"
        "Of another engine's recording, I and J are the engine's numbers of nodes, and the volumes "
        "its "
        "own: how the recorded test\n"
        "ended, the exact answer, and whether the test was right. With --volume and the like the "
        "nodes "
        "are of own hierarchies.\n\n"
        "FILE.json is a list of pairs, or one: {\"a\": VOLUME, \"b\": VOLUME, \"pose\": [12 "
        "numbers, [R|t] row by row, B in A's\nframe; may be left out]}, where VOLUME is one of\n"
        "  {\"center\": [x,y,z], \"radius\": r, \"normal\": [x,y,z], \"e\": e, \"f\": f}\n"
        "  {\"center\": [x,y,z], \"radius\": r}\n"
        "  {\"center\": [x,y,z], \"radius\": r, \"slabs\": [{\"normal\": [x,y,z], \"e\": e, \"f\": "
        "f}, {...}]}\n"
        "  {\"center\": [x,y,z], \"axes\": [[x,y,z],[x,y,z],[x,y,z]], \"half\": [x,y,z]}\n\n"
        "Examples:\n"
        "  scb explain spheres-l1 --frames 250 --pair 7164,1873 --test corrected\n"
        "  scb explain spheres-l1 --frames 50 --pair 25912,15272 --test printed\n"
        "  scb explain engine.scbrec --frames 2 --pair 226,248\n"
        "  scb explain --pairs volumes.json --json\n"
        "  scb explain --pairs volumes.json -o out/");
    command.callback([&action, &console, command, options] {
        note_given(command, *options);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
