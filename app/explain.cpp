#include <array>
#include <charconv>
#include <memory>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/explain_report.h"
#include "app/interrupt.h"
#include "app/number_list.h"
#include "app/progress.h"
#include "app/query_source.h"
#include "app/trace_input.h"
#include "core/error.h"
#include "scenes/utf8.h"

namespace scb {
namespace {

struct Options {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query{.frames = auto_frames};
    std::string pair, pairs_file;
    bool json = false;
    /// Of those given, the ones that --pairs has no use for, and those that a trace knows.
    std::vector<std::string> of_scenes, recording;
};

/// The numbers of --pair; throws InputError.
std::array<std::int64_t, 2> node_numbers(const std::string& pair) {
    const std::vector<std::string> parts = split_list(pair);
    std::array<std::int64_t, 2> nodes{};
    bool good = parts.size() == 2;
    for (std::size_t i = 0; good && i < 2; ++i) {
        const char* end = parts[i].data() + parts[i].size();
        const auto parsed = std::from_chars(parts[i].data(), end, nodes[i]);
        good = parsed.ec == std::errc() && parsed.ptr == end;
    }
    if (!good)
        throw InputError("--pair " + pair +
                         ": give the numbers of two nodes, I,J: one of the first body's hierarchy "
                         "and one of the second's.");
    return nodes;
}

void check(const Options& options) {
    const bool of_scene = !options.scene.names.empty();
    if (of_scene == !options.pairs_file.empty())
        throw InputError(of_scene
                             ? "--pairs: the file has the volumes, so there is no scene to name; "
                               "leave out one of them."
                             : "there is nothing to explain; give SCENE --frame N --pair I,J, or "
                               "--pairs FILE.json.");
    if (of_scene && options.pair.empty())
        throw InputError(
            "which nodes? Give --pair I,J: one of the first body's hierarchy and one "
            "of the second's (`scb trace --events` prints those that were tested).");
    if (of_scene) node_numbers(options.pair);
    if (!of_scene && !options.of_scenes.empty())
        throw InputError(options.of_scenes[0] +
                         ": it is of scenes, and --pairs has raw volumes; leave it out.");
    options.query.overlap();
}

/// A scene or a trace of one, at a frame.
struct SceneAtFrame {
    QuerySource source;
    int frame;
};

SceneAtFrame open_scene(const Options& options) {
    QueryOptions query = options.query;
    const std::string& name = options.scene.names[0];
    const bool trace = options.scene.names.size() == 1 && names_trace(name);
    if (trace) refuse_for_trace(options.recording, name);
    if (trace && options.scene.frame) query.frames = std::to_string(*options.scene.frame);
    QuerySource source(options.scene, options.hierarchy, query, {});
    const int frame = trace ? source.frames()[0] : options.scene.frame_of(source.query().scene);
    return {std::move(source), frame};
}

/// What the answers of many pairs come to.
struct Summary {
    std::size_t pairs = 0, rejected = 0, false_positives = 0;
    std::vector<std::size_t> false_negatives;

    void add(const ExplainedPair& pair) {
        rejected += pair.found.steps.stage() != Stage::overlapping;
        false_positives += pair.found.answer == Answer::false_positive;
        if (pair.found.answer == Answer::false_negative) false_negatives.push_back(pairs);
        ++pairs;
    }
    int exit_status() const { return false_negatives.empty() ? exit_done : exit_different; }
    std::string text() const {
        std::string text = std::to_string(pairs) + (pairs == 1 ? " pair: " : " pairs: ") +
                           std::to_string(rejected) + " rejected, " +
                           std::to_string(pairs - rejected) + " passed; " +
                           std::to_string(false_positives) + " false positives, " +
                           std::to_string(false_negatives.size()) + " false negatives";
        constexpr std::size_t most = 10;
        for (std::size_t i = 0; i < false_negatives.size() && i < most; ++i)
            text += (i == 0 ? (false_negatives.size() == 1 ? ": pair " : ": pairs ") : ", ") +
                    std::to_string(false_negatives[i]);
        return text + (false_negatives.size() > most ? ", ...\n" : "\n");
    }
};

/// Prints text in blocks, since together it may not fit into memory.
struct BlockPrinter {
    std::string text;

    void add(const std::string& more) {
        text += more;
        if (text.size() < std::size_t{1} << 16) return;
        print_result(text);
        text.clear();
    }
    void finish() { print_result(text); }
};

std::string json_text(const nlohmann::ordered_json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

int explain_scene(const Options& options, const Console& console) {
    const SceneAtFrame at = open_scene(options);
    const SceneQuery& query = at.source.query();
    note_doubts(options.scene, options.query, {query.kind}, console);
    const ExplainedPair pair =
        explained_nodes(query, at.frame, node_numbers(options.pair), "--pair " + options.pair);
    Summary summary;
    summary.add(pair);
    if (options.json) {
        nlohmann::ordered_json entry = {{"scene", query.scene.name}, {"frame", at.frame}};
        entry.update(explanation_json(pair));
        print_result(json_text(nlohmann::ordered_json::array({std::move(entry)}), 2) + "\n");
    } else {
        print_result(printable(query.scene.name) + ", frame " + std::to_string(at.frame) + ": " +
                     printable(node_names(pair)) + "\n" +
                     explanation_text(pair, console.colors_results()));
    }
    return summary.exit_status();
}

int explain_volumes(const Options& options, const Console& console) {
    const std::vector<AnyRawPair> pairs = read_raw_pairs(options.pairs_file);
    const OverlapOptions overlap = options.query.overlap();
    std::vector<VolumeKind> kinds;
    for (const AnyRawPair& pair : pairs)
        kinds.push_back(pair.index() == 0 ? VolumeKind::scb : VolumeKind::ball);
    if (!pairs.empty()) note_doubts(options.query, kinds, console);

    const bool colored = console.colors_results();
    const InterruptWatch watch;
    Progress progress(console, pairs.size());
    Summary summary;
    BlockPrinter out;
    if (options.json) out.add("[");
    for (const AnyRawPair& raw : pairs) {
        if (watch.signal() != 0) break;
        const ExplainedPair pair = explained_volumes(raw, overlap);
        const std::size_t i = summary.pairs;
        summary.add(pair);
        if (options.json) {
            nlohmann::ordered_json entry = {{"pair", i}};
            entry.update(explanation_json(pair));
            // One alone is for people, many are for programs.
            out.add((i == 0 ? "\n" : ",\n") + json_text(entry, pairs.size() == 1 ? 2 : -1));
        } else {
            out.add("pair " + std::to_string(i) + " of " + printable(options.pairs_file) + "\n" +
                    explanation_text(pair, colored) + "\n");
        }
        progress.step("pairs");
    }
    if (options.json)
        out.add(pairs.empty() ? "]\n" : "\n]\n");
    else if (pairs.size() != 1)
        out.add(summary.text());
    out.finish();
    if (summary.pairs == pairs.size()) return summary.exit_status();
    console.note("scb: interrupted; " + std::to_string(summary.pairs) + " of " +
                 std::to_string(pairs.size()) + " pairs are explained.");
    return exit_interrupted(watch.signal());
}

int run(const Options& options, const Console& console) {
    check(options);
    return options.pairs_file.empty() ? explain_scene(options, console)
                                      : explain_volumes(options, console);
}

}  // namespace

void add_explain(CLI::App& program, const Console& console, Action& action) {
    CLI::App* command = program.add_subcommand(
        "explain", "One overlap test of two volumes, step by step, and whether it is right");
    const auto options = std::make_shared<Options>();
    add_scene_options(*command, options->scene, true);
    command->get_option("SCENE")->required(false)->expected(0, 2)->description(
        "A built-in scene (see `scb scenes`), a scene file, two mesh files, or a "
        "trace (see `scb trace`)");
    command
        ->add_option("--pair", options->pair,
                     "Node I of the first body's hierarchy and J of the second's")
        ->type_name("I,J");
    command
        ->add_option("--pairs", options->pairs_file,
                     "In place of a scene: pairs of volumes of your own engine, see below")
        ->check(has_name())
        ->type_name("FILE.json");
    add_hierarchy_options(*command, options->hierarchy, false);
    add_overlap_options(*command, options->query, false);
    add_bodies_option(*command, options->query);
    command->add_flag("--json", options->json, "Print a list with an object per pair");
    command->footer(
        "A step that separates has a positive slack: by that much; the first one made decides. "
        "Then what is so, exactly,\nwith what proves it, and what the other tests say. Exit status "
        "1 "
        "where the test rejected volumes that overlap.\n\n"
        "FILE.json is a list of pairs, or one: {\"a\": VOLUME, \"b\": VOLUME, \"pose\": [12 "
        "numbers, [R|t] row by row, B in A's\nframe; may be left out]}, where VOLUME is one of\n"
        "  {\"center\": [x,y,z], \"radius\": r, \"normal\": [x,y,z], \"e\": e, \"f\": f}\n"
        "  {\"center\": [x,y,z], \"radius\": r}\n"
        "  {\"center\": [x,y,z], \"axes\": [[x,y,z],[x,y,z],[x,y,z]], \"half\": [x,y,z]}\n\n"
        "Examples:\n"
        "  scb explain spheres-l1 --frame 100 --pair 412,97\n"
        "  scb explain spheres-l1 --frame 50 --pair 25912,15272 --test printed\n"
        "  scb explain --pairs volumes.json --json");
    command->callback([&action, &console, command, options] {
        for (const char* option :
             {"--pair", "--frame", "--pose", "--bodies", "--volume", "--growth", "--margin"})
            if (command->count(option) > 0) options->of_scenes.emplace_back(option);
        for (const char* option :
             {"--pose", "--volume", "--growth", "--margin", "--test", "--threshold", "--bodies"})
            if (command->count(option) > 0) options->recording.emplace_back(option);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb
