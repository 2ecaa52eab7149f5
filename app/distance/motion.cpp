#include <cmath>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/validators.h"
#include "app/distance/motion_report.h"
#include "app/query/distance_options.h"
#include "app/query/output_guard.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "scb/error.h"

namespace scb::app {
namespace {

int run(const MotionOptions& options, const Console& console) {
    check_one_format(options.json, options.csv);
    // A shorter time is below the rounding of late frames.
    if (!(options.tolerance >= 1e-9) || !(options.tolerance <= 1))
        throw InputError(format("--tolerance %g: give 1e-9 to 1 frame.", options.tolerance));
    SceneQuery query = open_query(options.scene, options.hierarchy, options.query, QueryLimits{});
    if (query.frames.size() < 2)
        throw InputError(options.scene.names[0] +
                         ": a motion goes from one frame to the next; give at least two frames.");
    note_doubts(options.hierarchy, {query.kind}, console.notes());
    note_doubts(options.scene, query.scene, options.query, {query.kind}, console.notes());
    MotionReport report(options, query);
    const InterruptWatch watch;
    Progress progress(console, query.frames.size() - 1);
    try {
        for (std::size_t i = 1; i < query.frames.size(); ++i) {
            report.add(query.frames[i - 1], query.frames[i],
                       [&watch] { return watch.signal() != 0; });
            progress.step("motions");
        }
    } catch (const MotionReport::Interrupted&) {
    }
    print_result(report.text());
    if (report.steps() + 1 == query.frames.size()) return exit_done;
    console.note("scb: interrupted; " + std::to_string(report.steps()) + " of " +
                 std::to_string(query.frames.size() - 1) + " motions are finished.");
    return exit_interrupted(watch.signal());
}

}  // namespace

void add_motion(const Command& program, const Console& console, Action& action) {
    const Command command = program.add_subcommand(
        "motion", "Find when two bodies first touch between the frames of a scene");
    const auto options = std::make_shared<MotionOptions>();
    set_distance_defaults(options->hierarchy, options->query);
    add_scene_options(command, options->scene, false);
    add_hierarchy_options(command, options->hierarchy, false);
    add_traversal_options(command, options->query);
    command
        .add_option("--tolerance", options->tolerance,
                    "How exactly the time of a contact is found, in frames")
        .check(real_number)
        .type_name("T")
        .show_default();
    command.add_flag("--csv", options->csv, "Print CSV instead of a table");
    command.add_flag("--json", options->json, "Print JSON instead of a table");
    command.footer(
        "Between two queried frames, the origin of a body moves on a straight line. The body turns "
        "about it at constant speed, by at\n"
        "most half a turn. Poses of frames in between are not used. Two bodies that are a distance "
        "apart stay apart for that distance\n"
        "over their speed. So the bodies are apart until `not before`. `at the latest` they touch, "
        "by an exact test at rounded poses.\n"
        "undecided: they may touch between the two times, where they come too near for the "
        "tolerance and the rounding of numbers.\n"
        "jumped: they touch between two frames, and are apart at both, so that queries at frames "
        "miss the contact. distances: how\n"
        "many distances were measured. Times are in frames.\n\n"
        "Examples:\n"
        "  scb motion scenes/samples/bracket.json --frames 0:99:10\n"
        "  scb motion a.ply b.ply --poses log.csv --tolerance 0.0001 --json");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
