#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command_text.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/open_file.h"
#include "app/cli/validators.h"
#include "app/cli/version.h"
#include "app/pictures/picture_name.h"
#include "app/pictures/picture_options.h"
#include "app/pictures/plot_file.h"
#include "app/query/distance_options.h"
#include "app/query/query_options.h"
#include "app/report/build_text.h"
#include "app/study/distance_setting_text.h"
#include "app/timing/tune_distance_report.h"
#include "app/timing/tune_layout_report.h"
#include "app/timing/tune_progress.h"
#include "app/timing/tune_report.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/platform/input_files.h"
#include "core/platform/number_list.h"
#include "core/platform/output_file.h"
#include "render/draw/renderer.h"
#include "scb/error.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

struct TuneCommandOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query{.frames = auto_frames};
    KindOptions kind;
    PictureOptions picture{.output = ""};
    int repeats = 5;
    bool every = false, no_time = false, json = false;
    std::string of_scene;  ///< the given options of the scene, see given_text
};

/// By default about fifty frames, spread over the whole scene.
std::vector<int> chosen_frames(const std::string& text, const scenes::Scene& scene) {
    if (text != auto_frames) return frames_of(scene, text);
    const std::vector<int> all = frames_of(scene, "all");
    const std::size_t step = std::max<std::size_t>(1, (all.size() + 49) / 50);
    std::vector<int> frames;
    for (std::size_t i = 0; i < all.size(); i += step) frames.push_back(all[i]);
    return frames;
}

void check_repeats(int repeats) {
    if (repeats < 1 || repeats > 1000)
        throw InputError("--repeat " + std::to_string(repeats) + ": give 1 to 1000.");
}

TuneOptions tune_options(const TuneCommandOptions& options) {
    check_repeats(options.repeats);
    const CollideOptions collide = options.query.collide();
    const BuildOptions build = options.hierarchy.build();
    TuneOptions result;
    result.base.volume = options.hierarchy.kind();
    result.base.split = build.split;
    result.base.descent = collide.descent;
    // Options without effect on these volumes keep their defaults, since other volumes may use
    // them.
    if (result.base.volume == VolumeKind::scb) result.base.overlap = collide.overlap;
    if (has_growth(result.base.volume)) result.base.growth = build.fit.growth;
    result.build = build;
    result.every = options.every;
    result.repeats = options.no_time ? 0 : options.repeats;
    result.layouts = tried_layouts();
    return result;
}

/// Sentences on how times were measured; `sorting`: whether a query sorts its pairs.
std::string time_conditions(int repeats, std::size_t frames, bool sorting) {
    return "Time: " + std::to_string(repeats) + (repeats == 1 ? " run" : " runs") + " over " +
           std::to_string(frames) + (frames == 1 ? " frame" : " frames") +
           ", in which the settings take turns, each after an untimed query of the same nodes; one "
           "thread, processor time" +
           (sorting ? ", sorting the pairs included. " : ". ") +
           (repeats == 1 ? ""
                         : "The interval is from the least to the most of the runs; where "
                           "two intervals meet, no difference was measured. ") +
           "Compiled by " + compiler_text() +
           ". Times differ from machine to machine and from run to run; counts do not.";
}

std::string conditions(const TuneCommandOptions& options, const SceneTuning& tuning) {
    const std::string built = build_sentence(tuning.build);
    if (options.no_time) return built;
    return (built.empty() ? "" : built + " ") +
           time_conditions(options.repeats, tuning.timed_frames.size(), true);
}

std::string command_to_use(const TuneCommandOptions& options, const SceneTuning& tuning) {
    return "scb collide" + options.of_scene +
           setting_options(tuning.rows[tuning.recommended()].setting);
}

/// The command for a packed layout, if one is quicker.
std::string layout_command(const TuneCommandOptions& options, const SceneTuning& tuning) {
    if (!tuning.quicker_layout) return "";
    return "scb collide" + options.of_scene +
           layout_options(tuning, tuning.layouts[*tuning.quicker_layout]);
}

std::string json_text(const TuneCommandOptions& options, const SceneTuning& tuning) {
    Json document = {{"version", SCB_VERSION}, {"source", utf8_names(options.scene.names)}};
    document.update(tune_json(tuning));
    document["margin"] = options.hierarchy.margin;
    document["split"] = split_method_name(options.hierarchy.split);
    document["command"] = command_to_use(options, tuning);
    if (tuning.quicker_layout) document["layout_command"] = layout_command(options, tuning);
    if (!options.no_time) {
        document["repeats"] = options.repeats;
        document["compiler"] = compiler_text();
    }
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The options of a run that are in its file names.
NamedOptions named_run(const TuneCommandOptions& options, const scenes::Scene& scene) {
    const TuneCommandOptions usual;
    NamedOptions named;
    named.add_if(options.hierarchy.volumes != usual.hierarchy.volumes, "volume",
                 options.hierarchy.volumes);
    name_build(named, options.hierarchy.build());
    named.add_if(options.query.test != usual.query.test, "test", options.query.test);
    named.add_if(options.query.threshold != usual.query.threshold, "threshold",
                 exact_number(options.query.threshold));
    named.add_if(options.query.descent != usual.query.descent, "descent",
                 std::string(descent_rule_name(options.query.descent)));
    named.add_if(!options.query.bodies.empty(), "bodies", options.query.bodies);
    name_pose(named, options.scene.pose);
    if (options.query.frames != usual.query.frames)
        name_frames(named, chosen_frames(options.query.frames, scene));
    named.add_if(options.every, "every");
    named.add_if(options.no_time, "no-time");
    named.add_if(!options.no_time && options.repeats != usual.repeats, "repeat",
                 std::to_string(options.repeats));
    return named;
}

std::string picture_file(const TuneCommandOptions& options, const scenes::Scene& scene) {
    NamedOptions named = named_run(options, scene);
    name_picture(named, options.picture);
    return picture_name(options.scene.file_stem(scene.name), "tune", named, "") + ".png";
}

/// Without the options of the picture, which do not affect tables.
std::string table_file(const TuneCommandOptions& options, const scenes::Scene& scene,
                       const char* ending) {
    return picture_name(options.scene.file_stem(scene.name), "tune", named_run(options, scene),
                        "") +
           ending;
}

void write_files(const TuneCommandOptions& options, const scenes::Scene& scene,
                 const SceneTuning& tuning, render::Renderer& renderer,
                 const std::filesystem::path& folder) {
    render::TuneFigure figure = tune_figure(tuning);
    figure.footnote = conditions(options, tuning);
    write_plot(std::move(figure), options.picture, renderer, folder / picture_file(options, scene),
               scene.name);
    write_file_whole(folder / table_file(options, scene, ".csv"), tune_csv(tuning));
    write_file_whole(folder / table_file(options, scene, ".json"), json_text(options, tuning));
}

DistanceTuneOptions distance_tune_options(const TuneCommandOptions& options) {
    check_repeats(options.repeats);
    DistanceTuneOptions result;
    result.build = options.hierarchy.build();
    result.base.volume = options.hierarchy.kind();
    result.base.split = result.build.split;
    result.base.growth = result.build.fit.growth;
    result.base.descent = options.query.descent;
    result.asked = *options.query.distance;
    result.asked.limits.descent = options.query.descent;
    result.repeats = options.repeats;
    return result;
}

std::string distance_json_text(const TuneCommandOptions& options, const DistanceTuning& tuning) {
    Json document = {{"version", SCB_VERSION}, {"source", utf8_names(options.scene.names)}};
    document.update(distance_tune_json(tuning));
    document["margin"] = options.hierarchy.margin;
    const auto command = [&](std::size_t row) {
        return "scb distance" + options.of_scene + distance_options(tuning.rows[row].setting);
    };
    document["command"] = command(tuning.best());
    document["unpacked_command"] = command(tuning.best_unpacked());
    document["repeats"] = options.repeats;
    document["compiler"] = compiler_text();
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string distance_text(const TuneCommandOptions& options, const DistanceTuning& tuning) {
    const auto use = [&](std::size_t row) {
        const DistanceSetting& setting = tuning.rows[row].setting;
        return "scb distance" + options.of_scene + distance_options(setting) +
               "\n  in C++: " + distance_code(tuning, setting) + "\n";
    };
    const std::size_t best = tuning.best(), unpacked = tuning.best_unpacked();
    const std::string built = build_sentence(tuning.build);
    return distance_tune_table(tuning) + "\n" + (built.empty() ? "" : built + " ") +
           time_conditions(options.repeats, tuning.frames.size(), tuning.asked.within.has_value()) +
           "\n\nTo use it: " + use(best) + (unpacked == best ? "" : "Unpacked: " + use(unpacked));
}

int interrupted(const InterruptWatch& watch, const Console& console) {
    console.note("scb: interrupted before the settings were compared; nothing was written.");
    return exit_interrupted(watch.signal());
}

BodyPair tuned_bodies(const TuneCommandOptions& options, const scenes::Scene& scene) {
    const BodyPair bodies = body_pairs(scene, options.query.bodies).front();
    if (bodies[0] == bodies[1])
        throw InputError("--bodies " + options.query.bodies +
                         ": `scb tune` times queries of two bodies, on packed layouts too; give "
                         "two, or see the settings that `scb inspect` lists.");
    return bodies;
}

int run_distance(const TuneCommandOptions& options, const Console& console) {
    const DistanceTuneOptions asked = distance_tune_options(options);
    const scenes::Scene scene = options.scene.load(options.query.frames);
    const auto [a, b] = tuned_bodies(options, scene);
    note_doubts(options.scene, scene, options.query, {asked.base.volume}, console.notes());
    const InterruptWatch watch;
    const std::optional<DistanceTuning> tuning =
        tune_distance(scene, a, b, chosen_frames(options.query.frames, scene), asked,
                      tune_progress(console, watch));
    if (!tuning) return interrupted(watch, console);
    print_result(options.json ? distance_json_text(options, *tuning)
                              : distance_text(options, *tuning));
    return exit_done;
}

int run(const TuneCommandOptions& options, const Console& console) {
    if (options.query.distance) return run_distance(options, console);
    const TuneOptions asked = tune_options(options);
    options.picture.check();
    const scenes::Scene scene = options.scene.load(options.query.frames);
    if (!options.picture.output.empty())
        for (const std::string& file :
             {table_file(options, scene, ".csv"), table_file(options, scene, ".json"),
              picture_file(options, scene)})
            refuse_input(std::filesystem::path(options.picture.output) / file, "-o");
    const auto [a, b] = tuned_bodies(options, scene);
    const std::vector<int> frames = chosen_frames(options.query.frames, scene);
    // For slab cut balls the threshold matters even if the base's test has none, since other tests
    // are tried.
    QueryOptions doubtful = options.query;
    if (asked.base.volume == VolumeKind::scb) doubtful.threshold = QueryOptions{}.threshold;
    note_doubts(options.scene, scene, doubtful, {asked.base.volume}, console.notes());

    const bool writes = !options.picture.output.empty();
    std::filesystem::path folder;
    std::optional<render::Context> context;
    std::optional<render::Renderer> renderer;
    if (writes) {
        folder = options.picture.output_folder();
        context.emplace(options.picture.backend());
        renderer.emplace(*context);
    }

    const InterruptWatch watch;
    const std::optional<SceneTuning> tuning =
        tune_scene(scene, a, b, frames, asked, tune_progress(console, watch));
    if (!tuning) return interrupted(watch, console);
    if (writes) write_files(options, scene, *tuning, *renderer, folder);
    std::string text = options.json ? json_text(options, *tuning) : tune_table(*tuning);
    if (!options.json) {
        if (const std::string said = conditions(options, *tuning); !said.empty())
            text += "\n" + said + "\n";
        text += "\n" + use_text(*tuning, command_to_use(options, *tuning),
                                layout_command(options, *tuning));
    }
    print_result(text);
    if (writes && options.picture.show)
        show_pictures({folder / picture_file(options, scene)}, console);
    if (options.picture.open) open_file(folder / picture_file(options, scene), console);
    return exit_done;
}

}  // namespace

void add_tune(const Command& program, const Console& console, Action& action) {
    const Command command = program.add_subcommand(
        "tune", "Find the best volume, split, overlap test and descent for a scene");
    const auto options = std::make_shared<TuneCommandOptions>();
    add_scene_options(command, options->scene, false);
    command.get_option("SCENE").description(
        "A built-in scene (see `scb scenes`), a scene file, or two mesh files");
    add_hierarchy_options(command, options->hierarchy, false);
    add_query_options(command, options->query, false);
    add_kind_options(command, options->kind);
    command.get_option("--frames")
        .description(
            "Frames: 0,250 or FIRST:LAST[:STEP] or all; auto is fifty from the whole scene");
    command.add_option("--repeat", options->repeats, "Time the best settings in N runs")
        .check(decimal_number)
        .type_name("N")
        .show_default();
    command.add_flag("--every", options->every,
                     "Count every setting, also of volumes and splits that are far from the best");
    command.add_flag("--no-time", options->no_time,
                     "Counts only, which are the same on every machine");
    add_figure_options(command, options->picture, "Folder for tables (CSV, JSON) and a picture");
    command.add_flag("--json", options->json, "Print JSON instead of a table");
    command.footer(
        "--volume, --split, --test, --threshold, --descent and --growth give the base, with which "
        "all are compared. The command counts\n"
        "every volume with every split, and what differs from the base in one other thing; then, "
        "for volumes and splits that come near\n"
        "the best, everything that can be chosen. Counts are the same on every machine. Then it "
        "tries packed layouts\n"
        "of the best, and times these, the base and the best. The best is the quickest of those "
        "timed, with --no-time the one with\n"
        "the least cost: the time of its tests by constants that are the same on every machine. "
        "B/tri: bytes of the\n"
        "hierarchies per triangle. The printed test misses pairs and is never best. Ctrl-C stops "
        "it, with exit status 130.\n\n"
        "With --kind distance or --within T the base is the default of `scb distance`. The command "
        "tries every volume, split, order\n"
        "and packed layout in a few frames, and times the quickest and the base, in turns. The "
        "best is the quickest if all of its\n"
        "runs are quicker than all runs of the base; else the base.\n\n"
        "Examples:\n"
        "  scb tune spheres-l1 -o out/\n"
        "  scb tune knots-l1 --frames 0:499:50 --no-time\n"
        "  scb tune a.ply b.ply --pose 1,0,0,0.5,0,1,0,0,0,0,1,0 --test corrected\n"
        "  scb tune spheres-l1 --kind distance");
    command.callback([&action, &console, command, options] {
        options->of_scene = given_text(
            command, {"SCENE", "--pose", "--poses", "--models", "--bodies", "--query", "--tag",
                      "--frames", "--margin", "--within", "--relative-error", "--limit"});
        take_kind(command, {"--test", "--threshold", "--every", "--no-time", "--output"},
                  options->scene, options->hierarchy, options->query, options->kind);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
