#include <memory>

#include "app/cli/commands.h"
#include "app/cli/validators.h"
#include "app/query/level_list.h"
#include "app/query/output_guard.h"
#include "app/query/scene_options.h"
#include "core/base/exit_status.h"
#include "core/volumes/shape.h"
#include "render/files/output_file.h"
#include "render/view/any_volume.h"
#include "render/view/palette.h"
#include "scb/error.h"
#include "scb/level_cover.h"
#include "scenes/meshes/mesh_export.h"
#include "scenes/meshes/volume_mesh.h"
#include "scenes/scene/scene_hierarchies.h"

namespace scb::app {
namespace {

// Viewers choke on more, and so does a 32-bit index.
constexpr std::size_t most_triangles = 40'000'000;

struct ExportOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    std::string levels;
    int segments = 32;
    std::string output;
};

void append(Mesh& mesh, const Mesh& part) {
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const Triangle& t : part.triangles)
        mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    if (mesh.triangles.size() > most_triangles)
        throw InputError("this level would take more than " + std::to_string(most_triangles) +
                         " triangles; give a coarser level or fewer --segments.");
}

int run(const ExportOptions& options, const Console& console) {
    if (options.segments < 3 || options.segments > 1024)
        throw InputError("--segments " + std::to_string(options.segments) +
                         ": give 3 to 1024 corners per circle.");
    const std::vector<VolumeKind> kinds = options.hierarchy.kinds();
    if (kinds.size() != 1)
        throw InputError("--volume " + options.hierarchy.volumes +
                         ": a file holds one kind; give one.");
    check_output(options.output, "-o");
    note_doubts(options.hierarchy, kinds, console);
    const scenes::Scene scene = options.scene.load();
    check_output(options.output, "-o");
    const int frame = options.scene.frame_of(scene);
    const std::vector<MeshTopology> topologies =
        scenes::build_topologies(scene, options.hierarchy.build().topology());
    const int level = parse_level(options.levels, scenes::deepest(topologies));
    const std::vector<AnyHierarchy> hierarchies =
        scenes::fit_meshes(topologies, kinds[0], options.hierarchy.build());

    std::vector<scenes::ExportPart> parts;
    std::size_t nodes = 0, left_out = 0;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const scenes::Body& body = scene.bodies[b];
        const AnyHierarchy& hierarchy = hierarchies[body.mesh];
        const Pose pose = scenes::pose_at(body.motion, frame);
        const render::Rgba8 color = render::category_color(b);
        scenes::ExportPart part{
            body.name, {}, {color.r / 255.0f, color.g / 255.0f, color.b / 255.0f}};
        for (const std::uint32_t node : level_cover(topology_of(hierarchy), level)) {
            std::visit(
                [&](const auto& h) {
                    const Mesh volume = scenes::volume_mesh(placed(shape_of(h.volumes[node]), pose),
                                                            options.segments);
                    left_out += volume.triangles.empty();
                    append(part.mesh, volume);
                },
                hierarchy);
            ++nodes;
        }
        if (!part.mesh.triangles.empty()) parts.push_back(std::move(part));
    }
    if (parts.empty())
        throw InputError(
            "Level " + options.levels +
            ": all volumes of this level are points or segments, which have no surface; "
            "nothing to write.");
    render::write_file_whole(options.output, scenes::encode_mesh(parts, options.output));
    console.note(
        options.output + ": " + std::to_string(nodes) + (nodes == 1 ? " volume" : " volumes") +
        (left_out == 0 ? ""
                       : ", of which " + std::to_string(left_out) + " without a surface left out"));
    return exit_done;
}

}  // namespace

void add_export(const Command& program, const Console& console, Action& action) {
    const Command command =
        program.add_subcommand("export", "Write a level as a mesh, for other viewers");
    const auto options = std::make_shared<ExportOptions>();
    add_scene_options(command, options->scene, true);
    add_hierarchy_options(command, options->hierarchy, false);
    command.add_option("--levels,--level", options->levels, "The level: a number, or 'leaves'")
        .required()
        .type_name("K");
    command.add_option("--segments", options->segments, "Corners per circle")
        .check(decimal_number)
        .show_default();
    command.add_option("-o,--output", options->output, "The file: .ply, .obj, .glb or .stl")
        .required()
        .type_name("FILE");
    command.footer("Example:\n  scb export spheres-l1 --levels 7 -o level-7.ply");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
