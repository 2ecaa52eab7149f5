#include <algorithm>
#include <memory>
#include <optional>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/query/collide_report.h"
#include "app/query/layout_options.h"
#include "app/query/output_guard.h"
#include "app/query/query_options.h"
#include "app/study/query_source.h"
#include "app/study/scene_query.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/platform/output_file.h"
#include "scb/error.h"
#include "scenes/recordings/recorded_trace.h"

namespace scb::app {
namespace {

const std::vector<std::string> contact_names = {"all", "crossing", "touching"};

/// Throws InputError if the recorded queries cannot be compared with exact pairs.
void check_recorded(const scenes::RecordedTrace& recorded, const std::string& file) {
    if (recorded.header().engine->objects)
        throw InputError(file +
                         ": its items are objects without triangles, so that there are no exact "
                         "pairs; see `scb trace` for what it recorded.");
    refuse_recorded_distances(recorded.header());
    if (recorded.sides()[0] == recorded.sides()[1])
        throw InputError(file +
                         ": its queries are of a body against itself, which this command does not "
                         "make; `scb inspect` judges their pairs.");
}

int run(CollideCommandOptions& options, const Console& console) {
    check_one_format(options.json, options.csv);
    if (!options.contacts.empty() && std::find(contact_names.begin(), contact_names.end(),
                                               options.contacts) == contact_names.end())
        throw InputError("--contacts " + options.contacts + ": give " + name_list(contact_names) +
                         ".");
    if (!options.pairs_out.empty()) check_output(options.pairs_out, "--pairs-out");
    const std::optional<PackedLayout> layout =
        options.layout.packed(options.hierarchy, options.query, options.limits);
    std::optional<scenes::RecordedTrace> recorded;
    // Recorded pairs can only be compared with all exact pairs of triangles.
    const bool whole = !options.first && options.limits.levels.empty() &&
                       options.limits.max_pairs == QueryLimits{}.max_pairs;
    for (const auto& [name, is_given] : {std::pair("--contacts", !options.contacts.empty()),
                                         std::pair("--expect", !options.expect.empty())})
        if (is_given && !whole)
            throw InputError(std::string(name) +
                             " needs all pairs of triangles; leave out --first, --max-pairs and "
                             "--levels.");
    if (options.patches && (options.first || !options.limits.levels.empty()))
        throw InputError("--patches needs pairs of triangles; leave out --first and --levels.");
    if (options.patches && !options.contacts.empty() && options.contacts != "all")
        throw InputError("--contacts " + options.contacts +
                         ": patches are of all pairs; give --contacts all, or leave out "
                         "--patches.");
    if (options.scene.is_recording() && !options.expect.empty())
        throw InputError("--expect " + options.expect + ": " + options.scene.names[0] +
                         " has pairs of its own, which are compared; leave out --expect.");
    if (options.scene.is_recording() && !options.contacts.empty() && options.contacts != "all")
        throw InputError("--contacts " + options.contacts +
                         ": recorded pairs are compared with all pairs; give --contacts all.");
    if (options.scene.is_recording() && whole) {
        recorded.emplace(options.scene.names[0], options.query.bodies, options.query.frames,
                         options.scene.selection);
        check_recorded(*recorded, options.scene.names[0]);
        note_left_out(*recorded, console.notes());
        options.query.bodies =
            recorded->header().bodies[0].name + "," + recorded->header().bodies[1].name;
    }
    SceneQuery query = open_query(options.scene, options.hierarchy, options.query, options.limits,
                                  QueriedBodies::all_pairs);
    if (recorded) query.frames = recorded->frames();
    if (layout) options.layout.pack(query, *layout);
    if (options.first) query.options.max_pairs = 1;
    note_doubts(options.hierarchy, {query.kind}, console.notes());
    options.layout.note_doubts(console.notes());
    note_doubts(options.scene, query.scene, options.query, {query.kind}, console.notes());

    CollideReport report(options, query, recorded ? &*recorded : nullptr);
    if (const std::string note = report.note(); !note.empty()) console.note("scb: " + note);
    if (!options.pairs_out.empty()) check_output(options.pairs_out, "--pairs-out");
    const InterruptWatch watch;
    Progress progress(console, query.frames.size());
    for (const int frame : query.frames) {
        if (watch.signal() != 0) break;
        report.add(frame);
        progress.step("frames");
    }
    const CollideSums& sums = report.sums();
    if (!options.pairs_out.empty() && sums.frames > 0)
        write_file_whole(options.pairs_out, report.pairs());
    print_result(report.text());
    if (!sums.complete && !options.first)
        console.note("scb: a query ended at " + std::to_string(options.limits.max_pairs) +
                     " pairs (--max-pairs); there may be more.");
    if (sums.frames == query.frames.size()) return report.agrees() ? exit_done : exit_different;
    console.note("scb: interrupted; " + std::to_string(sums.frames) + " of " +
                 std::to_string(query.frames.size()) + " frames are finished.");
    return exit_interrupted(watch.signal());
}

}  // namespace

void add_collide(const Command& program, const Console& console, Action& action) {
    const Command command =
        program.add_subcommand("collide", "Find the triangle pairs that intersect, with counts");
    const auto options = std::make_shared<CollideCommandOptions>();
    add_scene_options(command, options->scene, false);
    add_hierarchy_options(command, options->hierarchy, false);
    add_query_options(command, options->query, false);
    command.get_option("--bodies")
        .description(
            "Names of two bodies; one name twice: the body with itself. Default: all pairs of "
            "bodies");
    add_query_limits(command, options->limits);
    command.add_flag("--first", options->first,
                     "End a query at the first pair; with --layout, in the least time");
    add_layout_options(command, options->layout,
                       "Run the queries on packed hierarchies, as the library does, which count "
                       "N_v and N_p only");
    command
        .add_option("--contacts", options->contacts,
                    "crossing: only pairs whose triangles pass through each other; touching: only "
                    "pairs that meet without that, in a point, along a line or in one plane; all: "
                    "all pairs, with a column `touching`")
        .type_name("KIND")
        .offer(contact_names);
    command.add_flag("--patches", options->patches,
                     "Divide the pairs into contact patches, which are connected sets of pairs, "
                     "with the box and the deepest vertices of each; with --csv, only these; with "
                     "--pairs-out, a column `patch`");
    command
        .add_option(
            "--pairs-out", options->pairs_out,
            "Write the pairs to this CSV file: numbers of triangles from 0, in the order of the "
            "mesh files")
        .file({".csv"})
        .only_typed();
    command
        .add_option("--expect", options->expect,
                    "Compare the pairs with a file as --pairs-out writes it: name pairs that are "
                    "missing or false in the file, and exit with 1 if there are any")
        .file({".csv"});
    command.add_flag("--csv", options->csv, "Print CSV instead of a table");
    command.add_flag("--json", options->json, "Print JSON instead of a table");
    command.footer(
        "pairs: triangles that intersect (touching counts); N_v: tests of two volumes; N_p: tests "
        "of two triangles;\n"
        "N_u: points and directions that were transformed; depth: depth of A's node plus that of "
        "B's, at the deepest test.\n"
        "The other columns count the volume tests by stage: slab-ball means that A's slab and B's "
        "ball were apart. Stages of\n"
        "boxes are in --csv and --json only. Of a scene with more than two bodies, each row names "
        "its two bodies. Counts are\n"
        "the same on every machine. Ctrl-C keeps the frames that were finished and exits with "
        "130.\n\n"
        "Examples:\n"
        "  scb collide spheres-l1 --frames 0:499:50\n"
        "  scb collide a.ply b.ply --poses log.csv --pairs-out pairs.csv\n"
        "  scb collide spheres-l1 --frames 100 --patches\n"
        "  scb collide a.ply b.ply --poses log.csv --expect engine.csv");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
