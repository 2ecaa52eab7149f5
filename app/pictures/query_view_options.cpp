#include "app/pictures/query_view_options.h"

#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/query/distance_options.h"
#include "app/query/output_guard.h"
#include "app/query/query_options.h"
#include "core/platform/number_list.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {

void QueryViewOptions::check() {
    picture.check();
    camera.check();
    hierarchy.kind();
    hierarchy.build();
    query.collide();
    if (query.distance) check_distance(*query.distance);
    for (const std::string& name : scene.names)
        if (scenes::names_trace(name)) refuse_for_trace(recording, name);
    picture.video.check(picture.output);
    if (pick.empty()) return;
    const std::vector<std::string> parts = split_list(pick);
    const std::string hint = "; give X,Y in pixels from the left and the top.";
    if (parts.size() != 2) throw InputError("--pick " + pick + ": this is not a pixel" + hint);
    const PixelPosition at = {whole_number(parts[0], "--pick " + pick, hint),
                              whole_number(parts[1], "--pick " + pick, hint)};
    if (at.x < 0 || at.x >= picture.width() || at.y < 0 || at.y >= picture.height())
        throw InputError("--pick " + pick + ": the picture has the pixels 0,0 to " +
                         std::to_string(picture.width() - 1) + "," +
                         std::to_string(picture.height() - 1) + "; give one of these.");
    picture.pick = at;
}

QuerySources QueryViewOptions::open(const Console& console) const {
    QuerySources sources =
        open_sources(scene, hierarchy, query, limits, {compare, recording}, console.notes());
    if (picture.no_panel && sources.size() == 2)
        throw InputError(
            "--no-panel: of two queries that are compared, only captions say which is which; leave "
            "it "
            "out, or draw each alone.");
    const std::size_t frames = sources.front().frames().size();
    picture.check_count(frames + sheet,
                        frames > 1 ? "give one frame with --frames" : "leave out --sheet");
    if (picture.video.wanted()) check_output(picture.video.file, "--video", picture.output);
    return sources;
}

std::optional<SheetRun> QueryViewOptions::planned_sheet(
    std::size_t count, const std::optional<render::ComparisonLayout>& layout) const {
    if (!sheet) return std::nullopt;
    SheetRun run;
    run.view = picture.layout().view;
    if (layout) {
        // Both views, and the space between them.
        const render::PixelRect &first = layout->sides[0].view, &second = layout->sides[1].view;
        run.view = {first.x, first.y, second.x + second.width - first.x,
                    second.y + second.height - first.y};
    }
    const std::optional<render::FrameSheetLayout> cells =
        render::frame_sheet_layout(count, run.view);
    if (!cells)
        throw InputError("--sheet: a sheet has room for " +
                         render::count_text(render::most_frame_cells(run.view)) +
                         " pictures, and this run has " + render::count_text(count) +
                         "; give fewer, or leave out --sheet.");
    run.sheet.layout = *cells;
    return run;
}

void add_query_view_options(const Command& command, QueryViewOptions& options, Shown shown) {
    add_scene_options(command, options.scene, false);
    command.get_option("SCENE").description(
        std::string("A built-in scene (see `scb scenes`), a scene file, two mesh files, ") +
        (options.query.distance ? "or another engine's recording, whose meshes and poses are used"
         : shown == Shown::nothing
             ? "a trace (see `scb trace`), or another engine's recording"
             : "a trace (see `scb trace`), another engine's recording, or two "
               "of these to compare"));
    add_hierarchy_options(command, options.hierarchy, false);
    if (options.query.distance) {
        add_traversal_options(command, options.query);
        add_distance_options(command, *options.query.distance);
    } else {
        add_query_options(command, options.query, false);
        add_query_limits(command, options.limits);
    }
    options.shown = shown;
    if (shown != Shown::nothing) {
        add_picture_options(command, options.picture, options.camera);
        add_panel_option(command, options.picture);
        command.get_option("--camera")
            .description(
                "fit, orbit:AZIMUTH,ELEVATION[,DISTANCE[,X,Y,Z]] in degrees, contact (follows the "
                "contact), or a JSON file; default: the scene's camera, or from where most of the "
                "contact is visible")
            .offer({"fit", "contact", "orbit:"});
        command
            .add_flag("--usual-direction", options.camera.usual_direction,
                      "Look from the usual direction, also if a body hides the contact from there")
            .shareable();
        command
            .add_option(
                "--pick", options.pick,
                "Print the node or triangle under a pixel, counted from the left and the top")
            .type_name("X,Y")
            .shareable();
        if (!options.query.distance)
            command
                .add_option("--compare", options.compare,
                            "Two overlap tests (corrected,printed) or two volumes (scb,ball): draw "
                            "both side by side, and outline the differences")
                .any_case()
                .offer_list(compared_words())
                .type_name("A,B")
                .shareable();
        command
            .add_flag(
                "--sheet", options.sheet,
                "Also draw a sheet of all pictures, small, with their counts. A contact that is "
                "small in a picture is then shown closely in it")
            .shareable();
    } else {
        add_picture_options(command, options.picture);
    }
    add_video_options(command, options.picture.video);
    add_shard_options(command, options.picture.shards, "frames");
    command.get_option("--frames")
        .description("Frames: 0,250 or FIRST:LAST[:STEP] or all; auto is the scene's own")
        .offer({"all", "auto"});
}

}  // namespace scb::app
