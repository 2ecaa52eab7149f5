#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "app/cli/command_text.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/validators.h"
#include "app/cli/version.h"
#include "app/explain/explain_report.h"
#include "app/inspect/frame_findings.h"
#include "app/inspect/inspect_bodies.h"
#include "app/inspect/inspect_csv.h"
#include "app/inspect/inspect_findings.h"
#include "app/inspect/inspect_options.h"
#include "app/inspect/inspect_page.h"
#include "app/inspect/inspect_pictures.h"
#include "app/inspect/inspect_recording.h"
#include "app/inspect/inspect_report.h"
#include "app/query/poses_json.h"
#include "app/query/query_sources.h"
#include "app/timing/tune_layout_report.h"
#include "app/timing/tune_progress.h"
#include "app/timing/tune_report.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "scb/error.h"
#include "scenes/scene/pose_rows.h"

namespace scb::app {
namespace {

/// The report on the findings, without other settings yet.
InspectReport report_of(const QuerySource& source, const FrameFindings& found) {
    const SceneQuery& query = source.query();
    InspectReport report;
    report.header = source.header();
    report.frames = found.frames;
    for (const InspectedFrame& frame : found.frames) report.sum += frame.found;
    report.others = found.others;
    report.wrong = found.wrong.pairs();
    report.weak_tests = found.weak_tests.pairs();
    report.loose_fits = found.loose_fits.pairs();
    for (auto* worst : {&report.weak_tests, &report.loose_fits})
        for (FalsePair& pair : *worst)
            sharpen_margin(pair, query.hierarchy(query.a), query.hierarchy(query.b),
                           query.b_to_a(pair.frame));
    sort_by_waste(report.frames);
    report.causes =
        waste_causes(topology_of(query.hierarchy(query.a)), query.mesh(query.a),
                     topology_of(query.hierarchy(query.b)), query.mesh(query.b), found.vain);
    return report;
}

/// Limit of the frames of a trace in a command.
constexpr std::size_t most_named_frames = 20;

/// The scene in a command; for a trace, the scene as recorded.
std::string scene_words(const InspectOptions& options, const QuerySource& source) {
    if (!scenes::names_trace(options.scene.names[0])) return options.of_scene;
    std::string words;
    for (const std::string& name : source.header().source) words += " " + file_word(name);
    std::string frames;
    for (const int frame : source.frames())
        frames += (frames.empty() ? " --frames " : ",") + std::to_string(frame);
    if (source.frames().size() <= most_named_frames) words += frames;
    if (source.header().source.size() != 2) return words;
    std::string numbers;
    for (const double number : scenes::rows_of(source.query().b_to_a(source.frames()[0])))
        numbers += (numbers.empty() ? "" : ",") + format("%.17g", number);
    return words + " --pose=" + numbers;
}

/// Tries other settings; if interrupted, the report has none.
void find_settings(InspectReport& report, const InspectOptions& options, const QuerySource& source,
                   const Console& console, const InterruptWatch& watch) {
    const SceneQuery& query = source.query();
    const TraceHeader& header = report.header;
    TuneOptions asked;
    asked.base = {header.volume, header.split, header.options.overlap, header.options.descent,
                  header.growth};
    asked.build = query.build;
    asked.repeats = options.time ? 5 : 0;
    asked.layouts = options.time && !query.is_self();
    std::vector<int> frames;
    for (const std::size_t i : counted_frames(source.frames().size(), report.sum.counts.all))
        frames.push_back(source.frames()[i]);
    report.settings =
        tune_scene(query.scene, query.a, query.b, frames, asked, tune_progress(console, watch));
    if (!report.settings) return;
    const SceneTuning& found = *report.settings;
    const std::string scene = scene_words(options, source);
    report.command =
        "scb collide" + scene + setting_options(found.rows[found.recommended()].setting);
    if (found.quicker_layout)
        report.layout_command =
            "scb bench" + scene + layout_options(found, found.layouts[*found.quicker_layout]);
}

/// Sets the file names of a report, with the options that affect it.
void name_files(InspectReport& report, const InspectOptions& options, const QuerySource& source) {
    const InspectOptions usual;
    report.stem = options.scene.file_stem(report.header.scene);
    name_query(report.named, source, source);
    name_picture(report.named, options.picture);
    if (source.frames().size() != static_cast<std::size_t>(source.query().scene.frames))
        name_frames(report.named_frames, source.frames());
    NamedOptions of_page;
    of_page.add_if(options.top != usual.top, "top", std::to_string(options.top));
    of_page.add_if(options.time, "time");
    report.files = inspect_name(report, of_page);
}

/// The page of `scb view` with the frames of the pairs in the report; without pairs, the worst
/// frame.
std::string report_view(const InspectOptions& options, const InspectReport& report,
                        const Console& console) {
    std::set<int> frames;
    for (const auto* pairs : {&report.loose_fits, &report.weak_tests})
        for (const FalsePair& pair : *pairs) frames.insert(pair.frame);
    for (const WronglyRejectedPair& pair : report.wrong) frames.insert(pair.frame);
    if (frames.empty()) frames.insert(report.frames.front().frame);
    ViewOptions view = options.view;
    view.level.scene = options.scene;
    view.level.hierarchy = options.hierarchy;
    view.level.picture.background = options.picture.background;
    view.level.picture.gl = options.picture.gl;
    view.query = options.query;
    view.level.recording = options.recording;
    view.queries.clear();
    for (const int frame : frames)
        view.queries += (view.queries.empty() ? "" : ",") + std::to_string(frame);
    if (!scenes::names_trace(options.scene.names[0]))
        view.level.scene.frames = std::to_string(*frames.begin());
    return view_page(view, console);
}

/// Draws the report and writes all other files. Returns whether everything was drawn.
bool write_report(PictureRun& pictures, const InspectOptions& options, const QuerySources& sources,
                  const InspectReport& report, const Console& console,
                  const InterruptWatch& watch) {
    const SceneQuery& query = sources.front().query();
    Progress progress(
        console, 2 + report.wrong.size() + report.loose_fits.size() + report.weak_tests.size());
    const auto step = [&] {
        progress.step("pictures");
        return watch.signal() == 0;
    };
    bool whole = draw_inspection(pictures, options.picture, query, report, step);
    std::string bodies;
    if (whole) bodies = draw_bodies(pictures, options.picture, sources, report);
    whole = whole && step();
    std::string view;
    // The page needs whole queries.
    const bool all =
        query.options.stop_level < 0 && options.limits.max_pairs == QueryLimits{}.max_pairs;
    if (whole && all && !options.no_view) {
        try {
            view = report_view(options, report, console);
        } catch (const InputError& error) {
            console.note("scb: there is no page of `scb view`: " + std::string(error.what()));
        }
    }
    const InspectPage page{inspect_name(report) + ".png",
                           bodies,
                           options.picture.width(),
                           options.picture.height(),
                           options.picture.theme() == &render::light_theme,
                           options.command,
                           options.explain,
                           view.empty() ? "" : report.files + "_view.html"};
    nlohmann::ordered_json head = {{"command", "inspect"}};
    head.update(inspect_json(report));
    head["poses"] = poses_json(query.scene, query.frames);
    if (whole) {
        pictures.write(report.files + "_frames.csv", frames_csv(report));
        pictures.write(report.files + "_pairs.csv", pairs_csv(report));
        pictures.write(report.files + ".html", inspect_html(report, page));
        if (!page.view.empty()) pictures.write(page.view, view);
        pictures.finish(std::move(head), console);
    }
    return whole;
}

void print_report(const InspectOptions& options, const InspectReport& report) {
    print_result(options.picture.json ? json_text(inspect_json(report), 2) + "\n"
                                      : inspect_text(report));
}

int run(InspectOptions& options, const Console& console) {
    if (options.scene.is_recording() && asks_for_recorded(options.recording)) {
        refuse_with_shard(options.picture.shards, true, "SCENE",
                          "another engine's recording is judged as a whole");
        return inspect_recording(options, console);
    }
    options.check();
    options.picture.shards.check_folder(options.picture.output);
    QuerySources sources;
    sources.emplace_back(options.scene, options.hierarchy, options.query, options.limits, false);
    QuerySource& source = sources.front();
    const SceneQuery& query = source.query();
    note_doubts(options.hierarchy, {query.kind}, console);
    note_doubts(options.scene, options.query, {query.kind}, console);
    const InterruptWatch watch;
    const std::vector<int>& frames = source.frames();
    Parts parts(
        options.picture.shards, frames.size(), versions_json(nullptr),
        [&] { return subject_of(sources); }, options.picture.output);
    std::optional<PictureRun> pictures;
    if (options.draws() && !parts.are_of_shard()) {
        InspectReport named;
        named.header = source.header();
        name_files(named, options, source);
        pictures.emplace(
            options.picture, query.scene.name,
            std::vector<std::string>{named.files + ".html", named.files + "_view.html",
                                     named.files + "_frames.csv", named.files + "_pairs.csv"});
    }

    Progress progress(console, frames.size());
    const auto top = static_cast<std::size_t>(options.top);
    FrameFindings found(source.header(), top);
    std::size_t done = 0;
    for (; done < frames.size() && watch.signal() == 0; ++done) {
        const int number = frames[done];
        if (parts.are_merged()) {
            parts.read(done, [&](const nlohmann::ordered_json& made, const auto&) {
                found += findings_of_json(made, source, number, top);
            });
        } else if (parts.are_of_shard() && parts.is_made_here(done)) {
            FrameFindings of_frame(source.header(), top);
            of_frame.add(source, source.frame(number));
            parts.keep(done, findings_json(of_frame));
        } else if (!parts.are_of_shard()) {
            found.add(source, source.frame(number));
        }
        progress.step("frames");
    }
    if (parts.are_of_shard()) return finish_shard(parts, watch, console);
    // Partial queries, and queries with deliberate errors, cannot rate settings.
    const bool whole =
        found.complete && query.options.stop_level < 0 && query.mutation == Mutation::none;
    InspectReport report = report_of(source, found);
    if (watch.signal() == 0 && whole && report.sum.counts.missed == 0)
        find_settings(report, options, source, console, watch);
    if (pictures && watch.signal() == 0) {
        report.drawn = true;
        name_files(report, options, source);
        if (options.picture.json)
            pictures->print_instead(json_text(inspect_json(report), 2) + "\n");
        else
            pictures->say(inspect_text(report));
        if (!write_report(*pictures, options, sources, report, console, watch)) {
            report.drawn = false;
            print_report(options, report);
            console.note("scb: interrupted; not all pictures are drawn, and there is no page.");
            return exit_interrupted(watch.signal());
        }
    } else {
        print_report(options, report);
    }
    if (watch.signal() != 0) {
        console.note("scb: interrupted; " + std::to_string(done) + " of " +
                     std::to_string(frames.size()) + " frames were inspected" +
                     (pictures ? ", and nothing is drawn." : "."));
        return exit_interrupted(watch.signal());
    }
    const PassCounts& counts = report.sum.counts;
    if (counts.wrongly_rejected == 0) return exit_done;
    console.alarm("scb: " + wrong_rejections_sentence(counts));
    return exit_different;
}

}  // namespace

void add_inspect(const Command& program, const Console& console, Action& action) {
    const Command command = program.add_subcommand(
        "inspect",
        "Find pairs that passed the overlap test but should not have, and what they cost");
    const auto options = std::make_shared<InspectOptions>();
    add_scene_options(command, options->scene, false);
    command.get_option("SCENE").description(
        "A built-in scene (see `scb scenes`), a scene file, two mesh files, a trace (see `scb "
        "trace`), or another engine's recording");
    add_hierarchy_options(command, options->hierarchy, false);
    add_query_options(command, options->query, false);
    add_query_limits(command, options->limits);
    command
        .add_option("--top", options->top,
                    "List the K worst pairs for each reason, each at its worst frame; for a "
                    "recording the first K cases per problem (default 1)")
        .check(decimal_number)
        .type_name("K")
        .show_default()
        .shareable();
    command
        .add_flag("--time", options->time,
                  "Also time the best settings; times differ from run to run")
        .shareable();
    command.add_flag("--no-view", options->no_view, "Do not write the page of `scb view`")
        .shareable();
    add_picture_options(command, options->picture);
    options->picture.samples = PictureOptions{}.samples;
    command.get_option("--output")
        .default_str("")
        .description("Also write a page with pictures of the worst pairs, CSV and JSON");
    command.get_option("--json").description("Print JSON");
    add_shard_options(command, options->picture.shards, "frames");
    command.footer(
        "A pair of nodes passes the test for one of three reasons: triangles below it intersect "
        "(true); its volumes\n"
        "meet, but no triangles do (fit: the volumes are too loose); or not even the volumes meet "
        "(test: too weak).\n"
        "For fit and test, all tests that follow from the pair are wasted. Each verdict on two "
        "volumes is exact, and has a\n"
        "certificate. Then the command repeats the queries with other volumes, splits, tests and "
        "descent rules, and names the best\nsetting (`scb tune` tries more settings, and times "
        "them). Exit status 1 if the test rejected volumes that meet, as "
        "--test printed does.\n\n"
        "For another engine's recording the command checks: each tree is a tree and contains its "
        "triangles; each test is right\nfor the recorded volumes; no pair is missed or false. It "
        "explains each problem. Exit status 1: something is wrong; 4:\nno error was found, but "
        "parts could not be judged. -o draws the first case of each problem.\n\n"
        "Examples:\n"
        "  scb inspect spheres-l1 --frames 0:499:50\n"
        "  scb inspect spheres-l1 --frames 0:499:10 --top 20 -o out/\n"
        "  scb inspect knots-l1 --frames 0 --json\n"
        "  scb inspect engine.scbrec --top 5 -o out/");
    command.callback([&action, &console, command, options] {
        options->recording = given_recording_options(command);
        options->asks_top = command.count("--top") > 0;
        for (const char* option : {"--size", "--background", "--gl", "--jobs"})
            if (command.count(option) > 0) options->of_pictures.emplace_back(option);
        const std::vector<std::string> of_queries = {
            "SCENE",    "--pose",  "--models", "--volume",    "--growth",
            "--margin", "--split", "--test",   "--threshold", "--bodies"};
        options->of_scene = given_text(
            command, {"SCENE", "--pose", "--models", "--bodies", "--frames", "--margin"});
        options->view.note_given(command);
        options->view.descent = given_text(command, {"--descent"});
        options->explain = "scb explain" + given_text(command, of_queries);
        options->command = "scb inspect" + given_text(command, of_queries) +
                           given_text(command, {"--descent", "--frames", "--max-pairs", "--levels",
                                                "--top", "--size", "--background"}) +
                           " -o DIR";
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
