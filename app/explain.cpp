#include <array>
#include <charconv>
#include <memory>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/explain_pictures.h"
#include "app/explain_report.h"
#include "app/interrupt.h"
#include "app/number_list.h"
#include "app/progress.h"
#include "app/query_source.h"
#include "app/text_format.h"
#include "app/trace_input.h"
#include "core/error.h"
#include "render/volume_titles.h"
#include "scenes/utf8.h"

namespace scb {
namespace {

struct Options {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query{.frames = auto_frames};
    PictureOptions picture{.output = ""};
    CameraOptions camera;
    std::string pair, pairs_file;
    /// Of those given, the ones that --pairs has no use for, those that a trace knows, and those
    /// of pictures.
    std::vector<std::string> of_scenes, recording, of_pictures;

    bool draws() const { return !picture.output.empty(); }
};

/// No more pictures are drawn: they fill disks, and nobody looks at them.
constexpr std::size_t most_pictures = 1000;

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
    options.picture.check();
    options.camera.check();
    if (!options.draws() && !options.of_pictures.empty())
        throw InputError(options.of_pictures[0] + ": it is of pictures; say where with -o DIR.");
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

using Json = nlohmann::ordered_json;

/// What index.json says of the run.
Json index_head(const Options& options) {
    Json head = {{"command", "explain"}};
    head["options"] = {{"test", options.query.test},
                       {"threshold", options.query.threshold},
                       {"size", {options.picture.width(), options.picture.height()}},
                       {"samples", options.picture.samples},
                       {"background", options.picture.background}};
    return head;
}

/// "test corrected, threshold 0.5"; nothing of balls and boxes.
std::string asked_of(const ExplainedPair& pair) {
    if (pair.kind != VolumeKind::scb) return "";
    const OverlapOptions& asked = pair.options;
    std::string text = "test " + std::string(overlap_test_name(asked.test));
    if (has_threshold(asked.test)) text += format(", threshold %g", asked.threshold);
    return text;
}

int explain_scene(const Options& options, const Console& console) {
    const SceneAtFrame at = open_scene(options);
    const SceneQuery& query = at.source.query();
    const Scene& scene = query.scene;
    note_doubts(options.scene, options.query, {query.kind}, console);
    const ExplainedPair pair =
        explained_nodes(query, at.frame, node_numbers(options.pair), "--pair " + options.pair);
    Summary summary;
    summary.add(pair);
    Json entry = {{"scene", scene.name}, {"frame", at.frame}};
    entry.update(explanation_json(pair));
    const std::string title = printable(scene.name) + ", frame " + std::to_string(at.frame) + ": " +
                              printable(node_names(pair)) + "\n",
                      text = title + explanation_text(pair, console.colors_results());
    if (!options.draws()) {
        print_result(options.picture.json ? json_text(Json::array({entry}), 2) + "\n" : text);
        return summary.exit_status();
    }
    PictureRun pictures(options.picture);
    ExplainPicture picture;
    picture.name = scene.name + "_" + std::string(volume_kind_name(query.kind)) +
                   format("_explain_frame-%04d", at.frame);
    for (const ExplainedNode& node : *pair.nodes)
        picture.name += "_" + file_name_of(node.body) + "-" + std::to_string(node.index);
    picture.title = scene.name + " · " + std::string(volume_title(query.kind)) + " · explain · " +
                    node_names(pair);
    picture.subtitle = asked_of(pair);
    if (scene.frames > 1)
        picture.subtitle += (picture.subtitle.empty() ? "" : ", ") + format("frame %d", at.frame);
    picture.to_world = pose_at(scene.bodies[query.a].motion, at.frame);
    picture.camera = asked_camera(options.camera, &scene);
    draw_explanation(pictures, options.picture, options.camera, pair, picture, entry);
    pictures.say(text);
    entry["file"] = picture.name + ".png";
    if (options.picture.json) pictures.print_instead(json_text(Json::array({entry}), 2) + "\n");
    pictures.finish(index_head(options));
    return summary.exit_status();
}

/// The explanations of raw volumes, one after the other, as text or JSON, with pictures or without.
class VolumesReport {
  public:
    VolumesReport(const Options& options, const Console& console, std::size_t pairs)
        : options_(options), console_(console), pairs_(pairs) {
        if (options.draws()) pictures_.emplace(options.picture);
        if (json()) out_.add("[");
    }

    void add(const ExplainedPair& pair) {
        const std::size_t i = summary_.pairs;
        summary_.add(pair);
        Json entry;
        if (json() || pictures_) {
            entry = {{"pair", i}};
            entry.update(explanation_json(pair));
        }
        if (pictures_) entry["file"] = draw(pair, i, entry) + ".png";
        if (json())
            // One alone is for people, many are for programs.
            out((i == 0 ? "\n" : ",\n") + json_text(entry, pairs_ == 1 ? 2 : -1));
        else
            out("pair " + std::to_string(i) + " of " + printable(options_.pairs_file) + "\n" +
                explanation_text(pair, console_.colors_results()) + "\n");
    }

    const Summary& finish() {
        if (json())
            out(summary_.pairs == 0 ? "]\n" : "\n]\n");
        else if (pairs_ != 1)
            out(summary_.text());
        if (!pictures_) {
            out_.finish();
            return summary_;
        }
        if (json())
            pictures_->print_instead(std::move(text_));
        else
            pictures_->say(std::move(text_));
        Json head = index_head(options_);
        head["pairs"] = as_utf8(options_.pairs_file);
        pictures_->finish(std::move(head));
        return summary_;
    }

  private:
    bool json() const { return options_.picture.json; }
    /// With pictures, all at the end, when they are written.
    void out(const std::string& text) {
        if (pictures_)
            text_ += text;
        else
            out_.add(text);
    }
    std::string draw(const ExplainedPair& pair, std::size_t i, const Json& entry) {
        const std::string stem =
            file_name_of(std::filesystem::path(options_.pairs_file).stem().string());
        ExplainPicture picture;
        picture.name = stem + format("_explain_pair-%03zu", i);
        picture.title = stem + " · " + std::string(volume_title(pair.kind)) + " · explain" +
                        (pairs_ == 1 ? "" : format(" · pair %zu", i));
        picture.subtitle = asked_of(pair);
        picture.camera = asked_camera(options_.camera, nullptr);
        draw_explanation(*pictures_, options_.picture, options_.camera, pair, picture, entry);
        return picture.name;
    }

    const Options& options_;
    const Console& console_;
    const std::size_t pairs_;
    std::optional<PictureRun> pictures_;
    Summary summary_;
    BlockPrinter out_;
    std::string text_;
};

int explain_volumes(const Options& options, const Console& console) {
    const std::vector<AnyRawPair> pairs = read_raw_pairs(options.pairs_file);
    if (options.draws() && pairs.size() > most_pictures)
        throw InputError("-o " + options.picture.output + ": " + options.pairs_file + " has " +
                         std::to_string(pairs.size()) + " pairs, and at most " +
                         std::to_string(most_pictures) +
                         " are drawn; leave out -o, or give those that matter.");
    const OverlapOptions overlap = options.query.overlap();
    std::vector<VolumeKind> kinds;
    for (const AnyRawPair& pair : pairs)
        kinds.push_back(pair.index() == 0 ? VolumeKind::scb : VolumeKind::ball);
    if (!pairs.empty()) note_doubts(options.query, kinds, console);

    const InterruptWatch watch;
    Progress progress(console, pairs.size());
    VolumesReport report(options, console, pairs.size());
    std::size_t done = 0;
    for (; done < pairs.size() && watch.signal() == 0; ++done) {
        report.add(explained_volumes(pairs[done], overlap));
        progress.step("pairs");
    }
    const Summary& summary = report.finish();
    if (done == pairs.size()) return summary.exit_status();
    console.note("scb: interrupted; " + std::to_string(done) + " of " +
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
    add_picture_options(*command, options->picture, options->camera);
    command->remove_option(command->get_option("--ids"));
    command->get_option("--output")
        ->default_str("")
        ->description("Also draw a picture of every pair into this folder");
    command->get_option("--json")->description("Print a list with an object per pair");
    command->get_option("--camera")
        ->description(
            "fit, orbit:AZIMUTH,ELEVATION[,DISTANCE] in degrees, or a JSON file; else "
            "one that shows the step");
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
        "  scb explain --pairs volumes.json --json\n"
        "  scb explain --pairs volumes.json -o out/");
    command->callback([&action, &console, command, options] {
        for (const char* option :
             {"--pair", "--frame", "--pose", "--bodies", "--volume", "--growth", "--margin"})
            if (command->count(option) > 0) options->of_scenes.emplace_back(option);
        for (const char* option :
             {"--pose", "--volume", "--growth", "--margin", "--test", "--threshold", "--bodies"})
            if (command->count(option) > 0) options->recording.emplace_back(option);
        for (const char* option :
             {"--size", "--camera", "--up", "--ortho", "--samples", "--background", "--gl"})
            if (command->count(option) > 0) options->of_pictures.emplace_back(option);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb
