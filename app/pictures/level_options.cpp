#include "app/pictures/level_options.h"

#include "app/cli/choice.h"
#include "app/cli/command.h"
#include "app/query/query_options.h"
#include "scb/error.h"

namespace scb::app {

void LevelOptions::check() const {
    picture.check();
    camera.check();
    if (camera.follows_contact())
        throw InputError(
            "--camera contact: levels have no contact; give fit, orbit:... or a file.");
    hierarchy.kinds();
    hierarchy.build();
    if (opacity && !(*opacity >= 0 && *opacity <= 1))
        throw InputError("--opacity " + std::to_string(*opacity) +
                         ": give 0 (volumes hidden) to 1 (opaque).");
}

render::ColorBy LevelOptions::resolved_color_by(std::size_t bodies) const {
    return color_by.value_or(bodies > 1 ? render::ColorBy::body : render::ColorBy::thickness);
}

double LevelOptions::resolved_opacity() const { return opacity.value_or(mesh || edges ? 0.25 : 1); }

void add_level_options(const Command& command, LevelOptions& options) {
    add_scene_options(command, options.scene, true);
    add_hierarchy_options(command, options.hierarchy);
    command
        .add_option("--levels,--level", options.levels,
                    "Levels: 5,7,9,11 or 0:12 or 0:12:3 or leaves or all; auto: down to the first "
                    "that has 95 % of the leaves, and the deepest")
        .type_name("LIST")
        .offer({"leaves", "all", "auto"})
        .show_default()
        .shareable();
    add_picture_options(command, options.picture, options.camera);
    add_panel_option(command, options.picture);
    add_level_look(command, options);
    add_shard_options(command, options.picture.shards, "pictures");
    command.add_flag("--no-sheet", options.no_sheet, "Do not draw the sheet of all levels")
        .shareable();
}

void add_level_look(const Command& command, LevelOptions& options) {
    add_choice(command, "--color-by", options.color_by,
               optional_choices(choices_of(render::color_by_names), "auto"),
               "body, depth, radius, thickness, subtree, or the share of the surface that a volume "
               "holds; auto: "
               "body for two or more bodies, thickness for one")
        .type_name("WHAT")
        .shareable();
    command
        .add_option("--opacity", options.opacity,
                    "Opacity of the volumes, 0 to 1; below 1 the mesh shows through. Default 1, "
                    "or 0.25 with --mesh")
        .shareable();
    command.add_flag("--mesh", options.mesh, "Show the meshes, through translucent volumes")
        .shareable();
    command.add_flag("--edges", options.edges, "Show the meshes with their edges").shareable();
}

}  // namespace scb::app
