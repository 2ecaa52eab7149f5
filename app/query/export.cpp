#include <memory>

#include "app/cli/commands.h"
#include "app/cli/validators.h"
#include "app/query/output_guard.h"
#include "app/query/query_options.h"
#include "app/study/level_trees.h"
#include "core/base/exit_status.h"
#include "core/platform/output_file.h"
#include "core/volumes/any_volume.h"
#include "render/view/palette.h"
#include "scb/error.h"
#include "scb/level_cover.h"
#include "scenes/meshes/mesh_export.h"
#include "scenes/meshes/volume_mesh.h"

namespace scb::app {
namespace {

// Larger meshes are too much for viewers and for 32-bit indices.
constexpr std::size_t most_triangles = 40'000'000;

struct ExportOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    std::string levels;
    int segments = 32;
    std::string output;
    std::vector<std::string> recording;  ///< see given_hierarchy_options
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
    if (options.hierarchy.kinds().size() != 1)
        throw InputError("--volume " + options.hierarchy.volumes +
                         ": a file holds one kind; give one.");
    check_output(options.output, "-o");
    const LevelSubject subject = level_subject(options.scene, options.hierarchy, options.levels,
                                               options.recording, console.notes());
    check_output(options.output, "-o");
    if (subject.levels.size() != 1)
        throw InputError("--levels " + options.levels +
                         ": this command takes one level; give one.");

    std::vector<scenes::ExportPart> parts;
    std::size_t nodes = 0, left_out = 0;
    const std::vector<BodyAtFrame>& bodies = subject.trees[0].bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Tree& tree = *bodies[b].tree;
        const render::Rgba8 color = render::category_color(b);
        scenes::ExportPart part{
            bodies[b].name, {}, {color.r / 255.0f, color.g / 255.0f, color.b / 255.0f}};
        for (const std::uint32_t node : level_cover(tree.shape(), subject.levels[0])) {
            if (!tree.has_volume(node)) continue;
            const Mesh volume = std::visit(
                [&](const auto& v) {
                    return scenes::volume_mesh(placed(v, bodies[b].pose), options.segments);
                },
                tree.volume(node));
            left_out += volume.triangles.empty();
            append(part.mesh, volume);
            ++nodes;
        }
        if (!part.mesh.triangles.empty()) parts.push_back(std::move(part));
    }
    if (parts.empty())
        throw InputError(
            "Level " + options.levels +
            ": all volumes of this level are points or segments, which have no surface; "
            "nothing to write.");
    write_file_whole(options.output, scenes::encode_mesh(parts, options.output));
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
        .offer({"leaves"})
        .type_name("K");
    command.add_option("--segments", options->segments, "Corners per circle")
        .check(decimal_number)
        .show_default();
    command.add_option("-o,--output", options->output, "The file: .ply, .obj, .glb or .stl")
        .required()
        .file({".ply", ".obj", ".glb", ".stl"})
        .only_typed();
    command.footer("Example:\n  scb export spheres-l1 --levels 7 -o level-7.ply");
    command.callback([&action, &console, command, options] {
        options->recording = given_hierarchy_options(command);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
