#include <algorithm>
#include <memory>

#include "app/cli/commands.h"
#include "app/pictures/frame_pictures.h"
#include "app/pictures/level_figures.h"
#include "app/pictures/level_index.h"
#include "app/pictures/level_options.h"
#include "app/pictures/picture_name.h"
#include "app/pictures/picture_run.h"
#include "app/pictures/scene_camera.h"
#include "app/query/query_options.h"
#include "app/study/level_trees.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "render/figures/level_sheet.h"
#include "scb/error.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

NamedOptions named_options(const LevelOptions& options) {
    NamedOptions named;
    if (options.color_by)
        named.add("color-by", std::string(render::color_by_names[*options.color_by]));
    if (options.opacity) named.add("opacity", exact_number(*options.opacity));
    named.add_if(options.mesh, "mesh");
    named.add_if(options.edges, "edges");
    name_build(named, options.hierarchy.build());
    name_pose(named, options.scene.pose);
    name_view(named, options.picture, options.camera);
    name_picture(named, options.picture);
    return named;
}

std::string level_name(const NamedOptions& named, const std::string& stem,
                       const std::string& volumes, int level, int frame) {
    const std::string which = level == leaf_level ? "_level-leaves" : format("_level-%02d", level);
    return picture_name(stem, volumes + which, named, frame_part(frame));
}

/// The name of a sheet has its volumes and levels, as other pictures' names do.
std::string sheet_name(const NamedOptions& named, const LevelOptions& options,
                       const std::string& stem, int frame) {
    const LevelOptions usual;
    NamedOptions of_sheet;
    of_sheet.add_if(options.hierarchy.volumes != usual.hierarchy.volumes, "volume",
                    options.hierarchy.volumes);
    of_sheet.add_if(options.levels != usual.levels, "levels", options.levels);
    return picture_name(stem, "levels_sheet", of_sheet + named, frame_part(frame));
}

// The level's volumes are too large to share a view with deeper levels.
bool has_own_view(int level) { return level != leaf_level && level < render::first_shared_level; }

/// All volumes and levels side by side.
render::LevelSheet sheet_of(const LevelSubject& subject, const LevelFigures& figures) {
    const std::vector<int>& levels = subject.levels;
    const std::vector<LevelTrees>& trees = subject.trees;
    const render::LevelFigure& common = figures.common();
    std::vector<int> shared = levels;
    std::erase_if(shared, has_own_view);
    const render::Support held = figures.support_of(shared.empty() ? levels : shared);
    // If there is one level, the volumes stand side by side.
    const bool one_row = levels.size() == 1;
    render::LevelSheet sheet;
    sheet.layout = render::level_sheet_layout(
        one_row ? 1 : trees.size(), one_row ? trees.size() : levels.size(),
        common.detail.has_value(), render::aspect_of(held, common.camera.axes));
    sheet.title = subject.scene.name + " · levels";
    sheet.subtitle = common.subtitle;
    sheet.style = common.style;
    sheet.center = common.center;
    sheet.detail = common.detail;
    const auto sheet_camera = [&](const render::Support& shown) {
        render::Camera camera =
            camera_for(figures.wish(), shown,
                       static_cast<double>(sheet.layout.view_width) / sheet.layout.view_height);
        render::set_depth_range(camera, figures.support());
        return camera;
    };
    const render::Camera shared_camera = sheet_camera(held);
    std::vector<render::Camera> cameras;  // per level
    for (const int level : levels)
        cameras.push_back(has_own_view(level) ? sheet_camera(figures.support_of({level}))
                                              : shared_camera);
    for (std::size_t k = 0; k < trees.size(); ++k) {
        if (trees.size() > 1) sheet.note += (k == 0 ? "" : "; ") + trees[k].title + ": ";
        sheet.note += render::lengths_words(figures.bodies(k).front().tree->family());
        if (k == 0 || !one_row) sheet.rows.emplace_back();
        std::vector<render::LevelSheetCell>& row = sheet.rows.back();
        for (std::size_t i = 0; i < levels.size(); ++i)
            row.push_back({trees[k].title + " · " + level_title(levels[i]), figures.bodies(k),
                           levels[i], cameras[i]});
    }
    return sheet;
}

int run(const LevelOptions& options, const Console& console) {
    options.check();
    const LevelSubject subject = level_subject(options.scene, options.hierarchy, options.levels,
                                               options.recording, console.notes());
    const scenes::Scene& scene = subject.scene;
    const std::string stem = options.scene.file_stem(scene.name);
    const int frame = subject.frame;
    const std::vector<LevelTrees>& trees = subject.trees;
    const std::size_t total = trees.size() * subject.levels.size();
    const bool with_sheet = total > 1 && !options.no_sheet;
    options.picture.check_count(total + with_sheet, "give one level with --levels and one volume");
    PictureRun pictures(options.picture, scene.name);
    const LevelFigures figures(options, subject, pictures.renderer());
    const render::LevelFigure& common = figures.common();

    const NamedOptions named = named_options(options);
    Progress progress(console, total);
    std::vector<std::string> names;
    for (const LevelTrees& each : trees) names.push_back(each.name);
    Json head = level_head(options, scene, names, frame, subject.levels,
                           exact_camera_view(figures.wish(), common.camera, common.center));
    pictures.plan(total, [&] { return head; });
    for (std::size_t k = 0; k < trees.size(); ++k)
        for (const int level : subject.levels) {
            const std::string name = level_name(named, stem, trees[k].name, level, frame);
            const auto draw = [&, k = k] {
                const render::Picture picture = render::compose(
                    figures.figure(k, level), options.picture.width(), options.picture.height(),
                    options.picture.samples, pictures.overlay());
                pictures.draw(name, picture,
                              level_entry(trees[k].name, level, frame, figures.bodies(k),
                                          options.picture.ids));
                return Json();
            };
            pictures.part(draw, take_nothing);
            progress.step(name);
        }
    if (pictures.is_shard()) {
        pictures.finish_shard(console);
        return exit_done;
    }
    if (with_sheet)
        pictures.draw(sheet_name(named, options, stem, frame),
                      render::compose(sheet_of(subject, figures), options.picture.samples,
                                      pictures.overlay()),
                      {{"sheet", true}}, false);
    // After plan(): shards of one run may have their meshes in other folders.
    head["source"] = utf8_names(options.scene.names);
    pictures.finish(head, console);
    return exit_done;
}

}  // namespace

void add_render_levels(const Command& render_command, const Console& console, Action& action) {
    const Command command = render_command.add_subcommand(
        "levels", "Draw the levels of the hierarchies, one picture each, and a sheet");
    const auto options = std::make_shared<LevelOptions>();
    add_level_options(command, *options);
    command.footer(
        "A level shows the nodes at that depth, and the leaves above it, so it covers the mesh. "
        "One camera and one scale\n"
        "hold for all pictures of a run, and others for its sheet, which is closer to the bodies. "
        "Beside them, index.json has their counts, the options, "
        "the camera (--camera\n"
        "takes the file again) and the versions.\n\n"
        "Examples:\n"
        "  scb render levels spheres-l1 --volume scb,ball --levels 5,7,9,11 -o out/\n"
        "  scb render levels part.stl --levels 0:12 --opacity 0.4 --camera orbit:40,15 -o out/");
    command.callback([&action, &console, command, options] {
        options->recording = given_hierarchy_options(command);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
