#include <algorithm>
#include <memory>

#include "app/cli/build_text.h"
#include "app/cli/commands.h"
#include "app/pictures/level_index.h"
#include "app/pictures/level_options.h"
#include "app/pictures/picture_name.h"
#include "app/pictures/picture_run.h"
#include "app/pictures/scene_camera.h"
#include "app/query/level_list.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "render/figures/level_sheet.h"
#include "render/figures/volume_titles.h"
#include "scb/error.h"
#include "scenes/scene/scene_hierarchies.h"

namespace scb::app {
namespace {

std::string level_title(int level) {
    return level == leaf_level ? "leaves" : "level " + std::to_string(level);
}

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

std::string level_name(const NamedOptions& named, const scenes::Scene& scene, VolumeKind kind,
                       int level, int frame) {
    const std::string which = level == leaf_level ? "_level-leaves" : format("_level-%02d", level);
    return picture_name(scene.name, std::string(volume_kind_name(kind)) + which, named,
                        frame_part(frame));
}

/// Which volumes and levels a sheet shows is a part of its name, as they are of the others'.
std::string sheet_name(const NamedOptions& named, const LevelOptions& options,
                       const scenes::Scene& scene, int frame) {
    const LevelOptions usual;
    NamedOptions of_sheet;
    of_sheet.add_if(options.hierarchy.volumes != usual.hierarchy.volumes, "volume",
                    options.hierarchy.volumes);
    of_sheet.add_if(options.levels != usual.levels, "levels", options.levels);
    return picture_name(scene.name, "levels_sheet", of_sheet + named, frame_part(frame));
}

// The frame, and every option that changes what is drawn but cannot be seen.
std::string subtitle_of(const LevelOptions& options, const scenes::Scene& scene, int frame,
                        int deepest_level, bool orthographic) {
    std::string text = "of levels 0 to " + std::to_string(deepest_level);
    if (scene.frames > 1)
        text += ", frame " + std::to_string(frame) + " of 0 to " + std::to_string(scene.frames - 1);
    text += build_text(options.hierarchy.build());
    if (orthographic) text += ", orthographic";
    const std::string up = up_words(options.camera, scene);
    if (!up.empty()) text += ", " + up;
    return text;
}

render::LevelStyle style_of(const LevelOptions& options, const scenes::Scene& scene,
                            int deepest_level, const std::vector<AnyHierarchy>& hierarchies) {
    render::LevelStyle style;
    style.opacity = options.resolved_opacity();
    style.mesh = options.mesh || options.edges || style.opacity < 1;
    style.mesh_edges = options.edges;
    style.theme = options.picture.theme();
    style.colors = {options.resolved_color_by(scene.bodies.size()), deepest_level,
                    render::largest_root(hierarchies)};
    return style;
}

// `meshes` is empty where none is drawn.
std::vector<render::LevelBody> bodies_of(const scenes::Scene& scene, int frame,
                                         const std::vector<AnyHierarchy>& hierarchies,
                                         const std::vector<render::MeshHandle>& meshes) {
    std::vector<render::LevelBody> bodies;
    std::uint32_t next_id = 1;
    for (const scenes::Body& body : scene.bodies) {
        render::LevelBody b;
        b.name = body.name;
        b.mesh = &scene.meshes[body.mesh].mesh;
        if (!meshes.empty()) b.handle = meshes[body.mesh];
        b.pose = scenes::pose_at(body.motion, frame);
        b.hierarchy = &hierarchies[body.mesh];
        b.first_id = next_id;
        const std::size_t nodes = topology_of(*b.hierarchy).nodes.size();
        if (nodes > 0xffffffffu - next_id)
            throw InputError("the scene has more nodes than 32-bit ids; use fewer bodies.");
        next_id += static_cast<std::uint32_t>(nodes);
        bodies.push_back(std::move(b));
    }
    return bodies;
}

// The deepest node of which a volume is drawn or counted.
int deepest_drawn(const std::vector<int>& levels) {
    if (std::find(levels.begin(), levels.end(), leaf_level) != levels.end())
        return FittedNodes{}.deepest;
    return *std::max_element(levels.begin(), levels.end());
}

// Its volumes are too large for a view to be shared with deeper levels.
bool has_own_view(int level) { return level != leaf_level && level < render::first_shared_level; }

int run(const LevelOptions& options, const Console& console) {
    options.check();
    const scenes::Scene scene = options.scene.load();
    const int frame = options.scene.frame_of(scene);
    const scenes::CameraView wish = camera_view_for(options.camera, scene);
    const std::vector<MeshTopology> topologies =
        scenes::build_topologies(scene, options.hierarchy.build().topology());
    const int deepest_level = scenes::deepest(topologies);
    const std::vector<int> levels =
        parse_levels(options.levels, deepest_level, scenes::telling_levels(topologies));
    const std::vector<VolumeKind> kinds = options.hierarchy.kinds();
    if (scene.bodies.size() == 2 && options.scene.names.size() == 2 && options.scene.pose.empty())
        console.note("scb: both bodies are at the same pose; --pose moves the second.");

    note_doubts(options.hierarchy, kinds, console);
    PictureRun pictures(options.picture, scene.name);
    std::vector<std::vector<AnyHierarchy>> hierarchies;  // per kind, per mesh
    for (const VolumeKind kind : kinds)
        for (AnyHierarchy& fitted : hierarchies.emplace_back(scenes::fit_meshes(
                 topologies, kind, options.hierarchy.build(), deepest_drawn(levels))))
            mutate(options.hierarchy.mutation, fitted);
    const render::LevelStyle style = style_of(options, scene, deepest_level, hierarchies[0]);
    std::vector<render::MeshHandle> meshes;
    if (style.mesh)
        for (const scenes::NamedMesh& mesh : scene.meshes)
            meshes.push_back(pictures.renderer().upload(mesh.mesh));
    std::vector<std::vector<render::LevelBody>> bodies;  // per kind
    for (const auto& h : hierarchies) bodies.push_back(bodies_of(scene, frame, h, meshes));
    const auto support_of = [&bodies](const std::vector<int>& shown) {
        std::vector<render::Support> of_kinds;
        for (const auto& b : bodies) of_kinds.push_back(render::support_of_levels(b, shown));
        return render::support_of_all(std::move(of_kinds));
    };
    const render::Support support = support_of(levels);

    render::LevelFigure figure;
    figure.style = style;
    figure.center = render::center_of(support);
    figure.with_panel = !options.picture.no_panel;
    if (wish.inset)
        figure.detail = render::Detail{detail_camera(wish, *wish.inset, support, 1),
                                       wish.inset->center, wish.inset->radius};
    const int width = options.picture.width(), height = options.picture.height();
    figure.camera = camera_for(wish, support, render::aspect_of(options.picture.layout().view));
    figure.subtitle = subtitle_of(options, scene, frame, deepest_level, figure.camera.orthographic);

    const NamedOptions named = named_options(options);
    const std::size_t total = kinds.size() * levels.size();
    std::size_t done = 0;
    for (std::size_t k = 0; k < kinds.size(); ++k)
        for (const int level : levels) {
            figure.title = scene.name + " · " + std::string(render::volume_title(kinds[k])) +
                           " · " + level_title(level);
            figure.bodies = bodies[k];
            figure.level = level;
            const render::Picture picture =
                render::compose(figure, width, height, options.picture.samples, pictures.overlay());
            const std::string name = level_name(named, scene, kinds[k], level, frame);
            pictures.draw(name, picture, level_entry(kinds[k], level, frame, bodies[k]));
            console.progress(name, ++done, total);
        }

    if (total > 1 && !options.no_sheet) {
        render::LevelSheet sheet;
        std::vector<int> shared = levels;
        std::erase_if(shared, has_own_view);
        const render::Support held = support_of(shared.empty() ? levels : shared);
        // Of one level the volumes stand side by side.
        const bool one_row = levels.size() == 1;
        const render::LevelSheetLayout layout = render::level_sheet_layout(
            one_row ? 1 : kinds.size(), one_row ? kinds.size() : levels.size(),
            figure.detail.has_value(), render::aspect_of(held, figure.camera.axes));
        sheet.layout = layout;
        sheet.title = scene.name + " · levels";
        sheet.subtitle = figure.subtitle;
        sheet.style = style;
        sheet.center = figure.center;
        sheet.detail = figure.detail;
        const auto sheet_camera = [&](const render::Support& shown) {
            render::Camera camera = camera_for(
                wish, shown, static_cast<double>(layout.view_width) / layout.view_height);
            render::set_depth_range(camera, support);
            return camera;
        };
        const render::Camera shared_camera = sheet_camera(held);
        std::vector<render::Camera> cameras;  // per level
        for (const int level : levels)
            cameras.push_back(has_own_view(level) ? sheet_camera(support_of({level}))
                                                  : shared_camera);
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            if (kinds.size() > 1)
                sheet.note +=
                    (k == 0 ? "" : "; ") + std::string(render::volume_title(kinds[k])) + ": ";
            sheet.note += render::lengths_words(*bodies[k].front().hierarchy);
            if (k == 0 || !one_row) sheet.rows.emplace_back();
            std::vector<render::LevelSheetCell>& row = sheet.rows.back();
            for (std::size_t i = 0; i < levels.size(); ++i)
                row.push_back(
                    {std::string(render::volume_title(kinds[k])) + " · " + level_title(levels[i]),
                     bodies[k], levels[i], cameras[i]});
        }
        const render::Picture picture =
            render::compose(sheet, options.picture.samples, pictures.overlay());
        pictures.draw(sheet_name(named, options, scene, frame), picture, {{"sheet", true}}, false);
    }
    pictures.finish(level_head(options, scene, frame, levels,
                               exact_camera_view(wish, figure.camera, figure.center)),
                    console);
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
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
