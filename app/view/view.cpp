#include <memory>

#include "app/cli/command_text.h"
#include "app/cli/commands.h"
#include "app/cli/open_file.h"
#include "app/cli/validators.h"
#include "app/query/distance_options.h"
#include "app/query/layout_options.h"
#include "app/query/output_guard.h"
#include "app/query/query_options.h"
#include "app/view/view_page.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "core/platform/output_file.h"
#include "scb/error.h"

namespace scb::app {
namespace {

/// Takes the query of one frame on packed hierarchies in place of the scene.
void take_packed(ViewOptions& options, const LayoutOptions& layout, const Console& console) {
    LevelOptions& level = options.level;
    if (!options.compare.empty())
        throw InputError("--layout " + layout.layout + ": --compare " + options.compare +
                         " compares queries that are not packed; leave one of them out.");
    if (options.queries != "auto")
        throw InputError("--layout " + layout.layout + ": --queries " + options.queries +
                         " has no effect, since the page has the query of one frame; name that "
                         "with --frames.");
    QueryOptions query = options.query;
    query.frames = level.scene.frames.empty() ? auto_frames : level.scene.frames;
    const InterruptWatch watch;
    level.scene = packed_queries(level.scene, level.hierarchy, query, {}, layout, console, watch);
    // The recording has these bodies as A and B.
    options.query.bodies.clear();
    level.recording.clear();
}

int run(ViewOptions& options, const LayoutOptions& layout, const Console& console) {
    options.check();
    const PictureOptions& picture = options.level.picture;
    if (layout.packed(options.level.hierarchy, options.query, {}))
        take_packed(options, layout, console);
    else
        layout.note_doubts(console.notes());
    const std::string html = view_page(options, console);
    check_output(picture.output, "-o");
    write_file_whole(picture.output, html);
    print_result(picture.output + "\n");
    console.note("scb: " + picture.output + ": " +
                 format("%.1f MB.", static_cast<double>(html.size()) / 1e6));
    if (picture.open) open_file(picture.output, console);
    return exit_done;
}

}  // namespace

void add_view(const Command& program, const Console& console, Action& action) {
    const Command command = program.add_subcommand(
        "view", "Write one HTML page that shows hierarchies and queries in any browser");
    const auto options = std::make_shared<ViewOptions>();
    const auto layout = std::make_shared<LayoutOptions>();
    LevelOptions& level = options->level;
    level.picture.output = "view.html";
    add_scene_options(command, level.scene, true);
    command.get_option("SCENE").description(
        "A built-in scene (see `scb scenes`), a scene file, one or two mesh files, a trace (see "
        "`scb trace`), or another engine's recording; two scenes, traces or recordings are "
        "compared");
    add_hierarchy_options(command, level.hierarchy);
    command
        .add_option("--level", level.levels,
                    "The level that is shown first; auto: the deepest with 500 volumes a body")
        .offer({"leaves", "auto"})
        .type_name("LEVEL")
        .show_default();
    command
        .add_option("--queries", options->queries,
                    "Frames whose queries the page holds, test by test: a list, all or none; auto: "
                    "the frame shown first, or all frames of a trace")
        .offer({"all", "none", "auto"})
        .type_name("FRAMES")
        .show_default();
    command
        .add_option("--compare", options->compare,
                    "Two overlap tests (corrected,printed), or a recording and a volume "
                    "(recorded,scb2): show both queries side by side, and outline the differences")
        .offer_list(compared_words())
        .type_name("A,B");
    command
        .add_option("--steps", options->steps,
                    "Embed step tables for the N costliest tests, spread over the frames")
        .type_name("N")
        .check(decimal_number)
        .show_default();
    add_overlap_options(command, options->query, false);
    add_bodies_option(command, options->query);
    add_kind_options(command, options->kind);
    command.get_option("--within").hide();
    add_layout_options(command, *layout, "Show the query of one frame on packed hierarchies");
    add_page_options(command, level.picture, level.camera, "The page");
    add_level_look(command, level);
    command.footer(
        "The page holds the hierarchies, the meshes and the poses of all frames, and loads nothing "
        "else. It draws volumes with the\nshaders and colors of the pictures. Its address "
        "describes the view, so that a link opens the same view.\n\n"
        "Examples:\n"
        "  scb view spheres-l1 -o spheres.html\n"
        "  scb view part.stl --volume scb2,obb --level 6 --color-by thickness -o part.html\n"
        "  scb view spheres-l1 --compare corrected,printed --frames 50 -o tests.html\n"
        "  scb view spheres-l1 --kind distance --frames 0 -o distance.html\n"
        "  scb view before.scbrec after.scbrec -o traces.html");
    command.callback([&action, &console, command, options, layout] {
        LevelOptions& asked = options->level;
        std::vector<std::string>& recording = asked.recording;
        recording = given_hierarchy_options(command);
        for (const char* option : {"--test", "--threshold", "--bodies"})
            if (command.count(option) > 0) recording.emplace_back(option);
        if (options->kind.distance.within)
            throw InputError(
                "--within: the page shows the smallest distance; see all triangles within a "
                "distance with `scb render distance --within T`.");
        take_kind(command, {"--test", "--threshold", "--compare", "--layout", "--steps"},
                  asked.scene, asked.hierarchy, options->query, options->kind);
        options->note_given(command);
        options->distances = given_text(command, {"--order", "--relative-error", "--limit"});
        options->levels = given_text(command, {"--color-by"});
        action = [&console, options, layout] { return run(*options, *layout, console); };
    });
}

}  // namespace scb::app
