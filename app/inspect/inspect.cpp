#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/command_text.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/validators.h"
#include "app/cli/version.h"
#include "app/explain/explain_report.h"
#include "app/inspect/inspect_files.h"
#include "app/inspect/inspect_findings.h"
#include "app/inspect/inspect_settings.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "scb/error.h"
#include "scenes/scene/kept_hierarchies.h"

namespace scb::app {
namespace {

void print_report(const InspectOptions& options, const InspectReport& report) {
    print_result(options.picture.json ? json_text(inspect_json(report), 2) + "\n"
                                      : inspect_text(report, options.full));
}

/// The first case that `scb explain` can explain; null if there is none.
const scenes::ProblemCase* explainable(const std::vector<scenes::ProblemGroup>& groups) {
    for (const scenes::ProblemGroup& group : groups)
        for (const scenes::ProblemCase& one : group.cases)
            if (one.has_volumes) return &one;
    return nullptr;
}

/// The command that explains the test of a case.
std::string explain_command(const scenes::ProblemCase& problem,
                            const scenes::RecordingJudgement& judged,
                            const InspectOptions& options) {
    const bool several = options.query.bodies.empty() && judged.summary.body_names.size() > 2;
    const std::string& name = problem.query.name;
    // A name is part of the command if it can be typed.
    const bool named =
        options.scene.selection.name.empty() && !name.empty() && printable(name) == name;
    return options.explain +
           (several ? " --bodies " + file_word(problem.query.a + "," + problem.query.b) : "") +
           (named ? " --query " + file_word(name) : "") + " --frames " +
           std::to_string(problem.query.frame) +
           format(" --pair %u,%u", problem.nodes.a, problem.nodes.b);
}

/// Notes on a recording: what the report lacks, and the next commands.
void note_next(const scenes::RecordingJudgement& judged, const InspectOptions& options,
               const Console& console) {
    const bool has_pictures =
        !judged.test_problems.empty() || !judged.missed.empty() || !judged.false_pairs.empty() ||
        std::any_of(judged.trees.begin(), judged.trees.end(),
                    [](const scenes::TreeJudgement& tree) { return !tree.problems.empty(); });
    if (judged.wrong() && has_pictures && !options.draws())
        console.note("scb: `scb inspect" + options.of_scene +
                     " -o out` draws the first of each kind of what is wrong.");
    const scenes::ProblemCase* const at_fault = explainable(judged.test_problems);
    const scenes::ProblemCase* const problem = at_fault ? at_fault : explainable(judged.missed);
    if (problem)
        console.note("scb: `" + explain_command(*problem, judged, options) + "` explains " +
                     (at_fault ? "a test at fault, step by step."
                               : "the test at which a missed pair was lost."));
}

int status_of(scenes::Verdict verdict) {
    switch (verdict) {
        case scenes::Verdict::valid:
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
    if (counts.wrongly_rejected == 0) {
        const auto [distances, certified] = certified_count(report);
        const bool is_open = certified < distances && !(report.header.distance.relative_error > 0);
        return is_open ? exit_partly_judged : exit_done;
    }
    console.alarm("scb: " + wrong_rejections_sentence(counts, report.header.kind));
    return exit_different;
}

int run(InspectOptions& options, const Console& console) {
    // The queries, the settings and the layouts share hierarchies.
    scenes::keep_hierarchies();
    options.check();
    const InterruptWatch watch;
    if (options.take_layout(console, watch) && watch.signal() != 0) {
        console.note("scb: interrupted; no query was inspected.");
        return exit_interrupted(watch.signal());
    }
    const bool recorded = options.scene.is_recording() && asks_for_recorded(options.recording);
    if (recorded)
        refuse_with_shard(options.picture.shards, true, "SCENE",
                          "another engine's recording is judged as a whole");
    options.picture.shards.check_folder(options.picture.output);
    InspectedQueries inspected = recorded ? open_recording(options) : open_scene(options, console);
    std::optional<PictureRun> pictures;
    InspectReport& report = inspected.report;
    if (options.time && options.no_advice && !recorded)
        console.note("scb: --time has no effect with --no-advice: it is of other settings.");
    if (recorded) {
        if (options.time)
            console.note(
                "scb: --time has no effect on recorded queries" +
                std::string(options.scene.recorded ? ", and --layout records them." : "."));
        judge(inspected, options, console, watch);
    } else {
        Parts parts(
            options.picture.shards, inspected.frames.size(), versions_json(nullptr),
            [&] { return subject_of(inspected.sources); }, options.picture.output);
        if (options.draws() && !parts.are_of_shard()) begin_pictures(pictures, inspected, options);
        inspect_frames(inspected, options, parts, console, watch);
        if (parts.are_of_shard()) return finish_shard(parts, watch, console);
    }
    if (!recorded && !inspected.found->complete)
        console.note("scb: a query ended at " + std::to_string(options.limits.max_pairs) +
                     " pairs; the report has the tests before.");
    const ExplainedPairs explained = report_waste(inspected);
    std::string no_settings =
        recorded && !report.recording->judged.wrong() ? inspected.no_waste : "";
    if (watch.signal() == 0 && !options.no_advice) {
        try {
            if (can_compare(inspected))
                report.settings = inspect_settings(options, inspected.sources.front(),
                                                   *inspected.found, console, watch);
            if (can_compare_distances(inspected) && (recorded || has_enough_tests(report)))
                report.distance_advice = distance_advice(options, inspected.sources.front(),
                                                         *inspected.found, console, watch);
        } catch (const InputError& error) {
            if (!recorded) throw;
            no_settings = error.what();
        }
    }
    if (recorded && options.draws() && watch.signal() == 0)
        begin_pictures(pictures, inspected, options);
    const bool draws = pictures && watch.signal() == 0;
    const bool whole =
        draws && write_report(*pictures, inspected, options, explained, console, watch);
    if (!whole) print_report(options, report);
    if (!no_settings.empty())
        console.note("scb: there is no comparison with this project's hierarchies: " + no_settings);
    if (recorded) note_next(report.recording->judged, options, console);
    if (watch.signal() != 0) {
        console.note(draws
                         ? "scb: interrupted; not all pictures are drawn, and there is no page."
                         : "scb: interrupted; " + std::to_string(inspected.done) + " of " +
                               std::to_string(inspected.frames.size()) + " frames were inspected" +
                               (options.draws() ? ", and nothing is drawn." : "."));
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
    add_kind_options(command, options->kind);
    add_query_limits(command, options->limits);
    add_layout_options(command, options->layout, "Inspect the queries on packed hierarchies");
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
    command
        .add_flag("--no-advice", options->no_advice,
                  "Do not try other settings, which can take most of the time")
        .shareable();
    command.add_flag("--full", options->full, "Print all tables").shareable();
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
        "With --kind distance, a pair passes if the bound of its distance is below the distance so "
        "far; with --within T, if the\nbound is at most T. A pair that passed in vain has one of "
        "three reasons: its volumes are nearer than the answer (fit: too\nloose); only the bound "
        "is "
        "(bound: too weak); or the answer was not known yet (early). A certificate proves each "
        "distance. Exit\nstatus 4 if one is not certified.\n\n"
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
        "  scb inspect spheres-l1 --frames 0 --kind distance\n"
        "  scb inspect engine.scbrec --top 5 -o out/");
    command.callback([&action, &console, command, options] {
        take_kind(
            command,
            {"--test", "--threshold", "--max-pairs", "--levels", "--layout", "--leaf", "--time"},
            options->scene, options->hierarchy, options->query, options->kind);
        options->recording = given_recording_options(command);
        options->asks_top = command.count("--top") > 0;
        for (const char* option : {"--size", "--background", "--gl", "--jobs"})
            if (command.count(option) > 0) options->of_pictures.emplace_back(option);
        const std::vector<std::string> of_queries = {
            "SCENE",   "--pose", "--poses",     "--models", "--volume", "--growth", "--margin",
            "--split", "--test", "--threshold", "--bodies", "--query",  "--tag"};
        std::vector<std::string> of_scene = {"SCENE",    "--pose",   "--poses",
                                             "--models", "--bodies", "--query",
                                             "--tag",    "--frames", "--margin"};
        if (command.count("--layout") > 0)
            for (const char* option : {"--layout", "--leaf", "--volume", "--growth", "--split"})
                of_scene.emplace_back(option);
        options->of_scene = given_text(command, of_scene);
        options->of_files = given_text(command, {"SCENE", "--models"});
        std::vector<std::string> of_meshes = {"SCENE", "--bodies", "--query", "--tag"};
        if (command.count("--layout") > 0)
            for (const char* option : {"--pose", "--poses", "--models", "--margin"})
                of_meshes.emplace_back(option);
        options->of_meshes = given_text(command, of_meshes);
        options->of_frames = given_text(command, {"--frames"});
        options->of_bodies =
            given_text(command, {"SCENE", "--pose", "--poses", "--models", "--bodies", "--margin"});
        options->of_distances = given_text(command, {"--within", "--relative-error", "--limit"});
        options->view.note_given(command);
        options->view.kind = options->kind;
        options->view.distances = given_text(command, {"--order", "--relative-error", "--limit"});
        options->view.descent = given_text(command, {"--descent"});
        options->explain = "scb explain" + given_text(command, of_queries);
        options->command =
            "scb inspect" + given_text(command, of_queries) +
            given_text(command, {"--descent", "--kind", "--order", "--within", "--relative-error",
                                 "--limit", "--frames", "--max-pairs", "--levels", "--layout",
                                 "--leaf", "--no-advice", "--top", "--size", "--background"}) +
            " -o DIR";
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
