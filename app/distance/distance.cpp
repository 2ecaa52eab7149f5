#include <cmath>
#include <memory>
#include <optional>
#include <tuple>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/open_file.h"
#include "app/cli/progress.h"
#include "app/distance/distance_report.h"
#include "app/pictures/picture_name.h"
#include "app/pictures/plot_file.h"
#include "app/query/distance_options.h"
#include "app/query/output_guard.h"
#include "app/query/query_options.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/platform/output_file.h"
#include "scb/error.h"

namespace scb::app {
namespace {

void check(const DistanceCommandOptions& options) {
    const std::optional<double>& within = options.query.distance->within;
    check_one_format(options.json, options.csv);
    check_distance(*options.query.distance);
    const DistanceOptions& limits = options.query.distance->limits;
    for (const auto& [name, is_given] : {std::pair("--within", within.has_value()),
                                         std::pair("--relative-error", limits.relative_error > 0),
                                         std::pair("--limit", std::isfinite(limits.limit))})
        if (is_given && options.prove)
            throw InputError(std::string("--prove certifies the smallest distance, and ") + name +
                             " asks for another answer; leave one of them out.");
    if (within && options.seeded)
        throw InputError(
            "--seed is of the smallest distance, and --within asks for all triangles within a "
            "distance; leave one of them out.");
    for (const auto& [name, is_given, needs] :
         {std::tuple("--first", options.first, within.has_value()),
          std::tuple("--expect-clear", options.expects_clear, within.has_value()),
          std::tuple("--pairs-out", !options.pairs_out.empty(), within && !options.first)})
        if (is_given && !needs)
            throw InputError(std::string(name) + (within ? " needs all pairs; leave out --first."
                                                         : " needs --within T."));
    if (!options.pairs_out.empty()) check_output(options.pairs_out, "--pairs-out");
    options.picture.check();
    if (within && !options.picture.output.empty())
        throw InputError(
            "-o is for a plot of distances, and --within asks for pairs; leave one of "
            "them out.");
}

/// Writes the plot into the folder, and shows it if asked for.
void write_distance_plot(const DistanceCommandOptions& options, DistanceReport& report,
                         const SceneQuery& query, const Console& console) {
    const std::filesystem::path folder = options.picture.output_folder();
    render::Context context(options.picture.backend());
    render::Renderer renderer(context);
    NamedOptions named;
    named.add_if(!options.query.bodies.empty(), "bodies", options.query.bodies);
    name_pose(named, options.scene.pose);
    if (options.query.frames != QueryOptions{}.frames) name_frames(named, query.frames);
    const DistanceOptions& limits = options.query.distance->limits;
    named.add_if(limits.relative_error > 0, "relative-error", exact_number(limits.relative_error));
    named.add_if(std::isfinite(limits.limit), "limit", exact_number(limits.limit));
    name_picture(named, options.picture);
    const std::filesystem::path file =
        folder /
        (picture_name(options.scene.file_stem(query.scene.name), "distance", named, "") + ".png");
    write_plot(report.plot(), options.picture, renderer, file, query.scene.name);
    if (options.picture.show) show_pictures({file}, console);
    if (options.picture.open) open_file(file, console);
}

int exit_status(const DistanceCommandOptions& options, const DistanceReport& report) {
    if (!report.is_proven()) return exit_different;
    if (!options.expects_clear) return exit_done;
    const std::optional<bool> clear = report.is_clear();
    return clear ? (*clear ? exit_done : exit_different) : exit_partly_judged;
}

int run(DistanceCommandOptions& options, const Console& console) {
    check(options);
    const std::optional<PackedLayout> layout =
        options.layout.packed(options.hierarchy, options.query, QueryLimits{});
    SceneQuery query = open_query(options.scene, options.hierarchy, options.query, QueryLimits{},
                                  QueriedBodies::all_pairs);
    // The inputs are known now, and must not be replaced.
    if (!options.pairs_out.empty()) check_output(options.pairs_out, "--pairs-out");
    if (layout) options.layout.pack(query, *layout);
    options.layout.note_doubts(console.notes());
    note_doubts(options.hierarchy, {query.kind}, console.notes());
    note_doubts(options.scene, query.scene, options.query, {query.kind}, console.notes());
    DistanceReport report(options, query);
    const InterruptWatch watch;
    Progress progress(console, query.frames.size());
    for (const int frame : query.frames) {
        if (watch.signal() != 0) break;
        report.add(frame);
        progress.step("frames");
    }
    if (!options.pairs_out.empty() && report.frames() > 0)
        write_file_whole(options.pairs_out, report.pairs());
    if (!options.picture.output.empty() && report.frames() > 0)
        write_distance_plot(options, report, query, console);
    print_result(report.text());
    // CSV has no place for the verdict.
    if (options.csv && options.expects_clear) console.note("scb: " + report.clearance_words());
    if (report.frames() == query.frames.size()) return exit_status(options, report);
    console.note("scb: interrupted; " + std::to_string(report.frames()) + " of " +
                 std::to_string(query.frames.size()) + " frames are finished.");
    return exit_interrupted(watch.signal());
}

}  // namespace

void add_distance(const Command& program, const Console& console, Action& action) {
    const Command command = program.add_subcommand(
        "distance", "Measure how far apart bodies are, with the closest points and counts");
    const auto options = std::make_shared<DistanceCommandOptions>();
    set_distance_defaults(options->hierarchy, options->query);
    add_scene_options(command, options->scene, false);
    add_hierarchy_options(command, options->hierarchy, false);
    add_traversal_options(command, options->query);
    command.get_option("--bodies").description("Names of two bodies. Default: all pairs of bodies");
    add_distance_options(command, *options->query.distance);
    add_layout_options(command, options->layout,
                       "Run the queries on packed hierarchies, as programs do: the same distances "
                       "in less time");
    command.add_flag("--first", options->first,
                     "With --within: end at the first pair, which answers whether any triangles "
                     "are that near");
    command.add_flag("--expect-clear", options->expects_clear,
                     "With --within: exit with 1 if triangles are that near in any frame or a body "
                     "lies inside another, and with 4 if this is not judged");
    command.add_flag("--seed", options->seeded,
                     "Begin each frame with the closest triangles of the frame before: the same "
                     "distances with fewer tests, whose number then depends on --frames");
    command.add_flag("--prove", options->prove,
                     "Certify each distance: a check that does not know the search bounds it from "
                     "both sides. Exit with 1 if a distance is not certified");
    command
        .add_option("--pairs-out", options->pairs_out,
                    "With --within: write the pairs to this CSV file: numbers of triangles from 0, "
                    "in the order of the mesh files")
        .file({".csv"})
        .only_typed();
    add_figure_options(command, options->picture, "Folder for a plot of the distance over frames");
    command.add_flag("--csv", options->csv, "Print CSV instead of a table");
    command.add_flag("--json", options->json, "Print JSON instead of a table");
    command.footer(
        "distance: the smallest distance of two triangles, 0 if and only if triangles intersect. "
        "If one body lies inside the\n"
        "other, the line says so, and signed_distance in --csv and --json is negative. N_v: pairs "
        "of volumes; N_p: pairs of\n"
        "triangles; N_u: points and directions that were transformed. near: volumes that are "
        "nearer than the answer so far;\n"
        "the other columns count the pairs that were left out, by the direction of the largest "
        "bound. Without --relative-error\n"
        "and --first, distances are equal for all volumes, orders and layouts, and on every "
        "machine. "
        "Points are in the frame of the\n"
        "first body.\n\n"
        "Examples:\n"
        "  scb distance spheres-l1 --frames 0:499:50\n"
        "  scb distance a.ply b.ply --poses log.csv --json\n"
        "  scb distance a.ply b.ply --poses log.csv --within 0.5 --pairs-out near.csv");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
