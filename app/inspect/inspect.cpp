#include <algorithm>
#include <filesystem>
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
#include "app/inspect/inspect_report.h"
#include "app/inspect/inspect_settings.h"
#include "app/inspect/recording_pictures.h"
#include "app/query/poses_json.h"
#include "app/query/query_sources.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/judge/query_attribution.h"
#include "core/platform/input_files.h"
#include "core/platform/number_list.h"
#include "core/platform/utf8.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"
#include "scenes/scene/pose_rows.h"

namespace scb::app {
namespace {

/// The queries to inspect, and all that is found about them.
struct Inspected {
    std::shared_ptr<const scenes::RecordingFile> file;   ///< null unless a recording
    std::shared_ptr<const scenes::Recording> recording;  ///< null if it has no tree
    QuerySources sources;  ///< one; none for a recording without queries of two chosen bodies
    std::string no_waste;  ///< why there is none: a sentence
    std::vector<int> frames;
    std::optional<FrameFindings> found;
    InspectReport report;
    std::optional<PictureRun> pictures;
    std::size_t done = 0;  ///< of the frames
};

/// Opens the recorded queries in the options. Without two chosen bodies, only the recording.
void open_recording(Inspected& result, const InspectOptions& options) {
    const std::string& path = options.scene.names[0];
    result.file = std::make_shared<const scenes::RecordingFile>(path, options.scene.selection);
    result.frames = frames_among(result.file->summary.frames, options.query.frames, path,
                                 "a recording may have");
    TraceHeader& header = result.report.header;
    header.scene = header.engine.emplace().name = std::filesystem::path(path).stem().string();
    try {
        result.recording =
            std::make_shared<const scenes::Recording>(scenes::read_recording(result.file));
        header.scene = result.recording->scene.name;
        header.engine->name = result.recording->engine;
        result.sources.emplace_back(result.recording, options.query);
        header = result.sources.front().header();
    } catch (const InputError& error) {
        result.no_waste = error.what();
    }
}

void open_scene(Inspected& result, const InspectOptions& options, const Console& console) {
    result.sources.emplace_back(options.scene, options.hierarchy, options.query, options.limits,
                                false);
    const QuerySource& source = result.sources.front();
    note_doubts(options.hierarchy, {source.query().kind}, console);
    note_doubts(options.scene, options.query, {source.query().kind}, console);
    result.report.header = source.header();
    result.frames = source.frames();
}

/// Sets the file names of the report, with the options that affect it.
void name_files(Inspected& inspected, const InspectOptions& options) {
    const InspectOptions usual;
    InspectReport& report = inspected.report;
    report.stem = options.scene.file_stem(report.header.scene);
    report.named = {};
    report.named_frames = {};
    std::size_t all = 0;
    if (!inspected.sources.empty()) {
        const QuerySource& source = inspected.sources.front();
        name_query(report.named, source, source);
        all = inspected.file ? inspected.file->summary.frames.size()
                             : static_cast<std::size_t>(source.query().scene.frames);
    }
    name_picture(report.named, options.picture);
    if (all != 0 && inspected.frames.size() != all)
        name_frames(report.named_frames, inspected.frames);
    NamedOptions of_page;
    of_page.add_if(options.top != usual.top, "top", std::to_string(options.top));
    of_page.add_if(options.time, "time");
    report.files = inspect_name(report, of_page);
}

/// Makes the folder of the pictures.
void begin_pictures(Inspected& inspected, const InspectOptions& options) {
    name_files(inspected, options);
    const std::string& files = inspected.report.files;
    inspected.pictures.emplace(
        options.picture,
        inspected.file ? scenes::file_name_of(inspected.report.header.engine->name)
                       : inspected.sources.front().scene().name,
        std::vector<std::string>{files + ".html", files + "_view.html", files + "_frames.csv",
                                 files + "_pairs.csv"});
}

/// Judges the recording, and attributes the tests of the two bodies on the way.
void judge(Inspected& inspected, const InspectOptions& options, const Console& console,
           const InterruptWatch& watch) {
    Progress progress(console, inspected.frames.size());
    const std::vector<int>& frames = inspected.frames;
    scenes::JudgedQueryVisitor visit;
    if (!inspected.sources.empty()) {
        QuerySource& source = inspected.sources.front();
        inspected.found.emplace(source.header(), static_cast<std::size_t>(options.top));
        visit = [&](const scenes::RecordedQueries& queries, const QueryJudgement& judged) {
            const TraceFrame* frame = source.recorded()->frame_at(queries);
            if (frame == nullptr) return;
            inspected.found->add(source, *frame,
                                 attribution(queries.query(), judged, source.header(), *frame));
        };
    }
    scenes::RecordingJudgement judged = scenes::judge_recording(
        *inspected.file,
        [&](int frame) { return std::binary_search(frames.begin(), frames.end(), frame); },
        [&](bool frame) {
            if (frame) progress.step("frames");
            return watch.signal() == 0;
        },
        visit);
    if (judged.trees.empty() && judged.summary.queries == 0)
        throw InputError(inspected.file->path +
                         ": it has no trees and no queries, so there is nothing to judge." +
                         (judged.damage.empty() ? "" : " " + judged.damage));
    inspected.done = frames.size() - judged.frames_left;
    const auto top = static_cast<std::size_t>(options.top);
    inspected.report.recording = {
        inspected.file->path, std::move(judged), top, options.asks_top ? top : 1, {}};
}

/// Makes or reads the queries of a scene frame by frame, until interrupted.
void inspect_frames(Inspected& inspected, const InspectOptions& options, Parts& parts,
                    const Console& console, const InterruptWatch& watch) {
    QuerySource& source = inspected.sources.front();
    const std::vector<int>& frames = inspected.frames;
    Progress progress(console, frames.size());
    const auto top = static_cast<std::size_t>(options.top);
    const auto inspect_frame = [&source](FrameFindings& findings, int number) {
        const TraceFrame& frame = source.frame(number);
        findings.add(source, frame, source.attribution(frame));
    };
    FrameFindings& found = inspected.found.emplace(source.header(), top);
    std::size_t& done = inspected.done;
    for (; done < frames.size() && watch.signal() == 0; ++done) {
        const int number = frames[done];
        if (parts.are_merged()) {
            parts.read(done, [&](const nlohmann::ordered_json& made, const auto&) {
                found += findings_of_json(made, source, number, top);
            });
        } else if (parts.are_of_shard() && parts.is_made_here(done)) {
            FrameFindings of_frame(source.header(), top);
            inspect_frame(of_frame, number);
            parts.keep(done, findings_json(of_frame));
        } else if (!parts.are_of_shard()) {
            inspect_frame(found, number);
        }
        progress.step("frames");
    }
}

WasteCauses causes_of(const QuerySource& source, int frame, const VainTests& vain) {
    const BodyAtFrame a = source.body(0, frame), b = source.body(1, frame);
    return waste_causes(depth(a.tree->shape()), *a.mesh, depth(b.tree->shape()), *b.mesh, vain);
}

/// Takes the findings over into the report. Returns the explanations of its pairs.
ExplainedPairs report_waste(Inspected& inspected) {
    InspectReport& report = inspected.report;
    if (!inspected.found || inspected.found->frames.empty()) {
        report.has_waste = false;
        return {};
    }
    const FrameFindings& found = *inspected.found;
    const QuerySource& source = inspected.sources.front();
    report.frames = found.frames;
    for (const InspectedFrame& frame : found.frames) report.sum += frame.found;
    // An error may be the cause of the waste of a recording that is wrong.
    if (inspected.file)
        report.has_waste = source.recorded()->tells_results() &&
                           !report.recording->judged.wrong() &&
                           report.sum.counts.all.volume_tests > 0;
    if (!report.has_waste) return {};
    report.others = found.others;
    report.wrong = found.wrong.pairs();
    report.weak_tests = found.weak_tests.pairs();
    report.loose_fits = found.loose_fits.pairs();
    ExplainedPairs explained = explain_pairs(report, source);
    sort_by_waste(report.frames);
    if (!report.header.engine || !report.header.engine->objects)
        report.causes = causes_of(source, found.frames.front().frame, found.vain);
    return explained;
}

/// Whether other settings can be compared with the queries: not with partial queries, with
/// deliberate errors, or with queries that miss contacts.
bool can_compare(const Inspected& inspected) {
    if (inspected.sources.empty()) return false;
    if (inspected.file) return !inspected.report.recording->judged.wrong();
    const SceneQuery& query = inspected.sources.front().query();
    return inspected.found->complete && query.options.stop_level < 0 &&
           query.mutation == Mutation::none && inspected.report.sum.counts.missed == 0;
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
    if (report.recording) {
        // The page has one frame of a recording, and one pair of bodies.
        view.query.bodies = report.header.bodies[0].name + "," + report.header.bodies[1].name;
        view.level.scene.frames = std::to_string(report.frames.front().frame);
        return view_page(view, console);
    }
    view.queries.clear();
    for (const int frame : frames)
        view.queries += (view.queries.empty() ? "" : ",") + std::to_string(frame);
    if (!scenes::names_trace(options.scene.names[0]))
        view.level.scene.frames = std::to_string(*frames.begin());
    return view_page(view, console);
}

/// Draws the pictures of the waste, writes its tables, and makes the page `view` of `scb view`.
/// Returns whether everything was drawn.
bool write_waste(Inspected& inspected, InspectPage& page, std::string& view,
                 const InspectOptions& options, const ExplainedPairs& explained,
                 const Console& console, const InterruptWatch& watch) {
    const InspectReport& report = inspected.report;
    PictureRun& pictures = *inspected.pictures;
    Progress progress(
        console, 2 + report.wrong.size() + report.loose_fits.size() + report.weak_tests.size());
    const auto step = [&] {
        progress.step("pictures");
        return watch.signal() == 0;
    };
    const QuerySource& source = inspected.sources.front();
    if (!draw_inspection(pictures, options.picture, source, report, explained, step)) return false;
    page.bodies = draw_bodies(pictures, options.picture, inspected.sources, report);
    if (!step()) return false;
    pictures.write(report.files + "_frames.csv", frames_csv(report));
    pictures.write(report.files + "_pairs.csv", pairs_csv(report));
    // The page of `scb view` needs whole queries.
    const bool all = inspected.file || (source.query().options.stop_level < 0 &&
                                        options.limits.max_pairs == QueryLimits{}.max_pairs);
    if (!all || options.no_view) return true;
    try {
        view = report_view(options, report, console);
        page.view = report.files + "_view.html";
    } catch (const InputError& error) {
        console.note("scb: there is no page of `scb view`: " + std::string(error.what()));
    }
    return true;
}

/// Draws the report and writes all other files. Returns whether everything was drawn.
bool write_report(Inspected& inspected, const InspectOptions& options,
                  const ExplainedPairs& explained, const Console& console,
                  const InterruptWatch& watch) {
    InspectReport& report = inspected.report;
    PictureRun& pictures = *inspected.pictures;
    InspectPage page;
    page.summary = inspect_name(report) + ".png";
    page.width = options.picture.width();
    page.height = options.picture.height();
    page.light = options.picture.theme() == &render::light_theme;
    page.command = options.command;
    page.explain = options.explain;
    if (inspected.file && inspected.recording)
        report.recording->pictures = draw_problems(pictures, options.picture, *inspected.recording,
                                                   report.recording->judged);
    report.drawn = report.has_waste;
    std::string view;
    if (report.has_waste &&
        !write_waste(inspected, page, view, options, explained, console, watch)) {
        report.drawn = false;
        return false;
    }
    pictures.write(report.files + ".html", inspect_html(report, page));
    if (!page.view.empty()) pictures.write(page.view, view);
    if (options.picture.json)
        pictures.print_instead(json_text(inspect_json(report), 2) + "\n");
    else
        pictures.say(inspect_text(report));
    nlohmann::ordered_json head = {{"command", "inspect"}};
    head.update(inspect_json(report));
    if (!inspected.file)
        head["poses"] = poses_json(inspected.sources.front().query().scene, inspected.frames);
    pictures.finish(std::move(head), console);
    return true;
}

void print_report(const InspectOptions& options, const InspectReport& report) {
    print_result(options.picture.json ? json_text(inspect_json(report), 2) + "\n"
                                      : inspect_text(report));
}

/// The command that explains the first faulty test; empty if there is none.
std::string explain_command(const scenes::RecordingJudgement& judged,
                            const InspectOptions& options) {
    for (const auto* groups : {&judged.test_problems, &judged.missed})
        for (const scenes::ProblemGroup& group : *groups) {
            const scenes::ProblemCase& first = group.cases.front();
            if (first.nodes.a == no_index || first.nodes.b == no_index) continue;
            const bool several =
                options.query.bodies.empty() && judged.summary.body_names.size() > 2;
            const std::string& name = first.query.name;
            // A name is part of the command if it can be typed.
            const bool named =
                options.scene.selection.name.empty() && !name.empty() && printable(name) == name;
            return options.explain +
                   (several ? " --bodies " + file_word(first.query.a + "," + first.query.b) : "") +
                   (named ? " --query " + file_word(name) : "") + " --frames " +
                   std::to_string(first.query.frame) +
                   format(" --pair %u,%u", first.nodes.a, first.nodes.b);
        }
    return {};
}

/// Notes on a recording: what the report lacks, and the next commands.
void note_next(const Inspected& inspected, const InspectOptions& options, const Console& console) {
    const scenes::RecordingJudgement& judged = inspected.report.recording->judged;
    if (judged.wrong() && !inspected.pictures)
        console.note("scb: `scb inspect" + options.of_scene +
                     " -o out` draws the first of each kind of what is wrong.");
    if (const std::string next = explain_command(judged, options); !next.empty())
        console.note("scb: `" + next + "` explains " +
                     (judged.test_problems.empty()
                          ? "the test at which the first missed pair was lost."
                          : "the first test at fault, step by step."));
}

int status_of(scenes::Verdict verdict) {
    switch (verdict) {
        case scenes::Verdict::sound:
            return exit_done;
        case scenes::Verdict::partly_judged:
            return exit_partly_judged;
        case scenes::Verdict::wrong:
            break;
    }
    return exit_different;
}

/// The exit status of a report that is not interrupted.
int status_of(const InspectReport& report, const Console& console) {
    if (report.recording) return status_of(report.recording->judged.verdict());
    const PassCounts& counts = report.sum.counts;
    if (counts.wrongly_rejected == 0) return exit_done;
    console.alarm("scb: " + wrong_rejections_sentence(counts));
    return exit_different;
}

int run(InspectOptions& options, const Console& console) {
    const bool recorded = options.scene.is_recording() && asks_for_recorded(options.recording);
    if (recorded)
        refuse_with_shard(options.picture.shards, true, "SCENE",
                          "another engine's recording is judged as a whole");
    options.check();
    options.picture.shards.check_folder(options.picture.output);
    Inspected inspected;
    if (recorded)
        open_recording(inspected, options);
    else
        open_scene(inspected, options, console);
    InspectReport& report = inspected.report;
    const InterruptWatch watch;
    if (recorded) {
        if (options.time)
            console.note("scb: --time has no effect on the recording of another engine.");
        judge(inspected, options, console, watch);
    } else {
        Parts parts(
            options.picture.shards, inspected.frames.size(), versions_json(nullptr),
            [&] { return subject_of(inspected.sources); }, options.picture.output);
        if (options.draws() && !parts.are_of_shard()) begin_pictures(inspected, options);
        inspect_frames(inspected, options, parts, console, watch);
        if (parts.are_of_shard()) return finish_shard(parts, watch, console);
    }
    const ExplainedPairs explained = report_waste(inspected);
    std::string no_settings =
        recorded && !report.recording->judged.wrong() ? inspected.no_waste : "";
    if (watch.signal() == 0 && can_compare(inspected)) {
        try {
            report.settings =
                inspect_settings(options, inspected.sources.front(), report.frames, console, watch);
        } catch (const InputError& error) {
            if (!recorded) throw;
            no_settings = error.what();
        }
    }
    if (recorded && options.draws() && watch.signal() == 0) begin_pictures(inspected, options);
    const bool draws = inspected.pictures && watch.signal() == 0;
    const bool whole = draws && write_report(inspected, options, explained, console, watch);
    if (!whole) print_report(options, report);
    if (!no_settings.empty())
        console.note("scb: there is no comparison with this project's hierarchies: " + no_settings);
    if (recorded) note_next(inspected, options, console);
    if (watch.signal() != 0) {
        console.note(draws
                         ? "scb: interrupted; not all pictures are drawn, and there is no page."
                         : "scb: interrupted; " + std::to_string(inspected.done) + " of " +
                               std::to_string(inspected.frames.size()) + " frames were inspected" +
                               (inspected.pictures ? ", and nothing is drawn." : "."));
        return exit_interrupted(watch.signal());
    }
    return status_of(report, console);
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
        "parts could not be judged. If nothing is wrong, the "
        "report has the same tables of passed pairs, with the\nengine's numbers of nodes. -o "
        "writes a page with the verdict, the first case of each problem, and the worst pairs.\n\n"
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
            "SCENE",   "--pose", "--models",    "--volume", "--growth", "--margin",
            "--split", "--test", "--threshold", "--bodies", "--query",  "--tag"};
        options->of_scene = given_text(command, {"SCENE", "--pose", "--models", "--bodies",
                                                 "--query", "--tag", "--frames", "--margin"});
        options->of_recording = given_text(command, {"SCENE", "--bodies", "--query", "--tag"});
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
