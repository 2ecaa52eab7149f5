#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/level_list.h"
#include "app/options.h"
#include "app/picture_options.h"
#include "app/scene_camera.h"
#include "app/scene_hierarchies.h"
#include "app/version.h"
#include "core/error.h"
#include "render/encode_queue.h"
#include "render/image_file.h"
#include "render/level_figure.h"
#include "render/renderer.h"

namespace scb {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    PictureOptions picture;
    CameraOptions camera;
    std::string levels = "auto";
    std::string color_by = "auto";
    double opacity = 1;
    bool mesh = false, edges = false, no_sheet = false;

    /// Refuses what makes no sense before any work is done.
    void check() const {
        picture.check();
        if (!(opacity >= 0 && opacity <= 1))
            throw InputError("--opacity: give 0 (volumes hidden) to 1 (opaque).");
        if (color_by != "auto" && !color_by_of(color_by))
            throw InputError("--color-by " + color_by +
                             ": give body, depth, radius, thickness or auto.");
    }
};

struct Run {
    const Options& options;
    const Console& console;
    Scene scene;
    int frame = 0;
    std::vector<MeshTopology> topologies;
    std::vector<VolumeKind> kinds;
    std::vector<int> levels;
    std::vector<std::vector<AnyHierarchy>> hierarchies;  // per kind, per mesh
    std::vector<std::vector<LevelBody>> bodies;          // per kind, per body
    Json files = Json::array();
    std::vector<std::string> written;
};

const char* title_of(VolumeKind kind) {
    switch (kind) {
        case VolumeKind::scb:
            return "SCB";
        case VolumeKind::ball:
            return "ball";
        case VolumeKind::ritter:
            return "Ritter's ball";
        case VolumeKind::obb:
            return "OBB";
    }
    return "";
}

std::string level_title(int level) {
    return level == leaf_level ? "leaves" : "level " + std::to_string(level);
}

std::string file_name(const Run& run, std::string_view what, const std::string& level) {
    char frame[32];
    std::snprintf(frame, sizeof frame, "_frame-%04d.png", run.frame);
    return run.scene.name + "_" + std::string(what) + level + frame;
}

std::string level_part(int level) {
    if (level == leaf_level) return "_level-leaves";
    char text[32];
    std::snprintf(text, sizeof text, "_level-%02d", level);
    return text;
}

LevelStyle style_of(const Run& run) {
    const Options& options = run.options;
    LevelStyle style;
    style.opacity = options.opacity;
    style.mesh = options.mesh || options.edges || options.opacity < 1;
    style.mesh_edges = options.edges;
    style.theme = options.picture.theme();
    const bool several = run.scene.bodies.size() > 1;
    style.colors.by =
        color_by_of(options.color_by).value_or(several ? ColorBy::body : ColorBy::thickness);
    style.colors.deepest = deepest(run.topologies);
    style.colors.root_diameter = 0;
    for (const AnyHierarchy& hierarchy : run.hierarchies[0])
        style.colors.root_diameter =
            std::max(style.colors.root_diameter,
                     std::visit([](const auto& h) { return diameter(h.volumes[0]); }, hierarchy));
    return style;
}

std::vector<LevelBody> bodies_of(const Run& run, const std::vector<AnyHierarchy>& hierarchies,
                                 const std::vector<MeshHandle>& meshes) {
    std::vector<LevelBody> bodies;
    std::uint32_t next_id = 1;
    for (const Body& body : run.scene.bodies) {
        LevelBody b;
        b.name = body.name;
        b.triangles = run.scene.meshes[body.mesh].mesh.triangles.size();
        b.mesh = meshes[body.mesh];
        b.pose = pose_at(body.motion, run.frame);
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

Json numbers_json(const Run& run, const std::vector<LevelBody>& bodies, int level) {
    const LevelNumbers numbers = level_numbers(bodies, level);
    Json list = Json::array();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const CoverStatistics& s = numbers.bodies[b];
        list.push_back({{"body", run.scene.bodies[b].name},
                        {"first_id", bodies[b].first_id},
                        {"volumes", s.volumes},
                        {"leaves", s.leaves},
                        {"mean_diameter", s.mean_diameter},
                        {"mean_thickness", s.mean_thickness},
                        {"area", s.area},
                        {"volume", s.volume}});
    }
    return list;
}

Json level_json(int level) { return level == leaf_level ? Json("leaves") : Json(level); }

std::string subtitle_of(const Run& run) {
    const std::string levels = "levels 0 to " + std::to_string(deepest(run.topologies));
    if (run.scene.frames == 1) return levels;
    return "frame " + std::to_string(run.frame) + " (0 to " + std::to_string(run.scene.frames - 1) +
           "), " + levels;
}

void add_file(Run& run, const std::string& name, Json entry) {
    run.written.push_back(name);
    entry["file"] = name;
    run.files.push_back(std::move(entry));
}

Json index_json(const Run& run, const GlInfo& gl, const CameraSpec& camera) {
    const Options& o = run.options;
    Json versions_json;
    for (const auto& [name, version] : versions(&gl)) versions_json[name] = version;
    Json levels = Json::array();
    for (const int level : run.levels) levels.push_back(level_json(level));
    Json kinds = Json::array();
    for (const VolumeKind kind : run.kinds) kinds.push_back(volume_kind_name(kind));
    return {{"command", "render levels"},
            {"scene", run.scene.name},
            {"frame", run.frame},
            {"options",
             {{"volume", kinds},
              {"levels", levels},
              {"growth", o.hierarchy.growth},
              {"margin", o.hierarchy.margin},
              {"size", {o.picture.width(), o.picture.height()}},
              {"samples", o.picture.samples},
              {"background", o.picture.background},
              {"color_by", o.color_by},
              {"opacity", o.opacity},
              {"mesh", o.mesh},
              {"edges", o.edges}}},
            {"camera", Json::parse(camera_json(camera))},
            {"versions", versions_json},
            {"files", run.files}};
}

int render(const Options& options, const Console& console) {
    options.check();
    Run run{options, console, options.scene.load(), 0, {}, options.hierarchy.kinds(), {},
            {},      {},      Json::array(),        {}};
    run.frame = options.scene.frame_of(run.scene);
    const FitOptions fit_options = options.hierarchy.fit();
    run.topologies = build_topologies(run.scene);
    run.levels = parse_levels(
        options.levels == "auto" ? "0:" + std::to_string(deepest(run.topologies)) : options.levels,
        deepest(run.topologies));
    const CameraSpec spec = camera_spec_for(options.camera, run.scene);
    const std::filesystem::path folder = options.picture.output_folder();

    const Context context(options.picture.backend());
    Renderer renderer(context);
    std::vector<MeshHandle> meshes;
    for (const NamedMesh& mesh : run.scene.meshes) meshes.push_back(renderer.upload(mesh.mesh));
    for (const VolumeKind kind : run.kinds)
        run.hierarchies.push_back(fit_meshes(run.topologies, kind, fit_options));
    for (const auto& hierarchies : run.hierarchies)
        run.bodies.push_back(bodies_of(run, hierarchies, meshes));
    const LevelStyle style = style_of(run);

    std::vector<Support> parts;
    for (const auto& bodies : run.bodies) parts.push_back(support_of_levels(bodies, run.levels));
    const Support support = support_of_all(std::move(parts));
    const Vec3 center = center_of(support);
    std::optional<Detail> detail;
    if (spec.inset)
        detail = Detail{detail_camera(spec, *spec.inset, support, 1), spec.inset->center,
                        spec.inset->radius};

    LevelFigure figure;
    figure.subtitle = subtitle_of(run);
    figure.style = style;
    figure.center = center;
    figure.detail = detail;
    const int width = options.picture.width(), height = options.picture.height();
    figure.camera = camera_for(spec, support, aspect_of(figure_layout(width, height).view));

    EncodeQueue queue(8, options.picture.jobs());
    Overlay overlay;
    const std::size_t total = run.kinds.size() * run.levels.size();
    for (std::size_t k = 0; k < run.kinds.size(); ++k)
        for (const int level : run.levels) {
            const std::string kind_name(volume_kind_name(run.kinds[k]));
            figure.title =
                run.scene.name + " · " + title_of(run.kinds[k]) + " · " + level_title(level);
            figure.bodies = run.bodies[k];
            figure.level = level;
            const Picture picture =
                compose(figure, width, height, options.picture.samples, overlay);
            Rendering rendering = renderer.draw(picture, &overlay, options.picture.ids);
            const std::string name = file_name(run, kind_name, level_part(level));
            queue.push(folder / name, std::move(rendering.image));
            Json entry = {{"file", name},
                          {"volume", kind_name},
                          {"level", level_json(level)},
                          {"frame", run.frame},
                          {"bodies", numbers_json(run, run.bodies[k], level)}};
            if (rendering.ids) {
                const std::string ids_name = name.substr(0, name.size() - 4) + "_ids.png";
                queue.push(folder / ids_name, std::move(*rendering.ids));
                entry["ids"] = ids_name;
                run.written.push_back(ids_name);
            }
            add_file(run, name, std::move(entry));
            console.progress(name, run.files.size(), total);
        }

    if (total > 1 && !options.no_sheet) {
        LevelSheet sheet;
        const LevelSheetLayout layout =
            level_sheet_layout(run.kinds.size(), run.levels.size(), detail.has_value());
        sheet.title = run.scene.name + " · levels";
        sheet.subtitle = subtitle_of(run);
        sheet.style = style;
        sheet.center = center;
        sheet.detail = detail;
        sheet.camera =
            camera_for(spec, support, static_cast<double>(layout.view_width) / layout.view_height);
        for (std::size_t k = 0; k < run.kinds.size(); ++k) {
            std::vector<LevelSheetCell>& row = sheet.rows.emplace_back();
            for (const int level : run.levels)
                row.push_back({std::string(title_of(run.kinds[k])) + " · " + level_title(level),
                               run.bodies[k], level});
        }
        const Picture picture = compose(sheet, options.picture.samples, overlay);
        const std::string name = file_name(run, "levels", "_sheet");
        queue.push(folder / name, renderer.draw(picture, &overlay).image);
        add_file(run, name, {{"file", name}, {"sheet", true}});
    }
    queue.finish();

    CameraSpec exact = exact_spec(spec, figure.camera, center);
    const std::string index = index_json(run, context.info(), exact).dump(2) + "\n";
    write_file_whole(folder / "index.json",
                     std::span(reinterpret_cast<const std::uint8_t*>(index.data()), index.size()));
    if (options.picture.json) {
        print_result(index);
    } else {
        std::string list;
        for (const std::string& name : run.written) list += (folder / name).string() + "\n";
        print_result(list + (folder / "index.json").string() + "\n");
    }
    return exit_done;
}

}  // namespace

void add_render_levels(CLI::App& render_command, const Console& console, Action& action) {
    CLI::App* command = render_command.add_subcommand(
        "levels", "The levels of the hierarchies, one picture each, and a sheet");
    const auto options = std::make_shared<Options>();
    add_scene_options(*command, options->scene, true);
    add_hierarchy_options(*command, options->hierarchy);
    command
        ->add_option("--levels", options->levels,
                     "Levels: 5,7,9,11 or 0:12 or leaves; auto is all of them")
        ->type_name("LIST")
        ->capture_default_str();
    add_picture_options(*command, options->picture, options->camera);
    command
        ->add_option(
            "--color-by", options->color_by,
            "body, depth, radius or thickness; auto is body for several, thickness for one")
        ->type_name("WHAT")
        ->capture_default_str();
    command
        ->add_option("--opacity", options->opacity,
                     "Opacity of the volumes; below 1 the mesh shows through")
        ->capture_default_str();
    command->add_flag("--mesh", options->mesh, "Draw the meshes too");
    command->add_flag("--edges", options->edges, "Draw the meshes with their edges");
    command->add_flag("--no-sheet", options->no_sheet, "No contact sheet");
    command->footer(
        "A level shows the nodes at that depth, and the leaves above it, so it covers the mesh. "
        "One camera and one scale\n"
        "hold for all pictures of a run. Beside them, index.json has their counts, the options, "
        "the camera (which\n"
        "--camera takes again) and the versions.\n\n"
        "Examples:\n"
        "  scb render levels spheres-l1 --volume scb,ball --levels 5,7,9,11 -o out/\n"
        "  scb render levels part.stl --levels 0:12 --opacity 0.4 --camera orbit:40,15 -o out/");
    command->callback([&action, &console, options] {
        action = [&console, options] { return render(*options, console); };
    });
}

}  // namespace scb
