#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/validators.h"
#include "app/query/output_guard.h"
#include "app/query/query_options.h"
#include "app/study/level_trees.h"
#include "app/study/scene_query.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/geometry/mesh_clean.h"
#include "core/geometry/mesh_cut.h"
#include "core/geometry/triangle_pair.h"
#include "core/platform/number_list.h"
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
// Pieces take some 100 bytes each while they are made.
constexpr std::size_t most_pieces = 4'000'000;

struct ExportOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    std::string levels;
    int segments = 32;
    std::string output;
    double cut = 0;         ///< the longest side of pieces; 0: a level is written
    std::string triangles;  ///< to cut; empty: all with longer sides
    std::string body, map;
    bool clean = false;  ///< writes the mesh without copies and degenerate triangles
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

/// The index of the body whose mesh is changed.
std::size_t changed_body(const scenes::Scene& scene, const std::string& name) {
    if (name.empty() && scene.bodies.size() == 1) return 0;
    if (const auto body = body_named(scene, name)) return *body;
    throw InputError((name.empty() ? std::string("the scene has several bodies; name one")
                                   : "--body " + name + ": the scene has no such body; name one") +
                     " with --body: " + name_list(scene.bodies, &scenes::Body::name) + ".");
}

/// Throws InputError if the numbers of a file would change the pieces: all formats have floats.
void check_rounding(const Mesh& mesh, double longest) {
    double most = 0;
    for (const Vec3& vertex : mesh.vertices)
        most = std::max(most, (vertex - vertex.cast<float>().cast<double>()).cwiseAbs().maxCoeff());
    if (most > longest / 1000)
        throw InputError(format("-o: the file would round coordinates to 32 bits, by up to %.3g, "
                                "and the sides of pieces are at most %.3g; ",
                                most, longest) +
                         "move the mesh nearer to its origin, or give a larger --cut.");
}

/// A mesh with a part of the changes of the command.
struct ChangedMesh {
    Mesh mesh;
    std::vector<std::uint32_t> origin;  ///< per triangle, the triangle of the original
    std::string words;                  ///< the changes, for the user
};

ChangedMesh cut(const Mesh& mesh, const std::string& body, const ExportOptions& options) {
    std::vector<std::uint32_t> seeds;
    if (!options.triangles.empty())
        for (const std::string& part : split_list(options.triangles))
            for (const int triangle :
                 parse_numbers(part, {"--triangles", "triangle", body + " has",
                                      static_cast<int>(mesh.triangles.size()) - 1, "12,40:50"}))
                seeds.push_back(static_cast<std::uint32_t>(triangle));
    std::optional<CutMesh> cut = cut_triangles(mesh, seeds, options.cut, most_pieces);
    if (!cut)
        throw InputError("--cut " + exact_number(options.cut) + ": this would make more than " +
                         count_text(most_pieces) + " pieces; give a longer side.");
    check_rounding(cut->mesh, options.cut);
    return {std::move(cut->mesh), std::move(cut->origin),
            counted(cut->cut, "triangle", "triangles") + " cut into " +
                counted(cut->pieces, "piece", "pieces")};
}

ChangedMesh cleaned(const Mesh& mesh) {
    CleanMesh clean = clean_mesh(mesh);
    if (clean.origin.size() == 1 && is_degenerate(corners(clean.mesh, 0)))
        throw InputError("--clean: all triangles of the mesh are without area; nothing is left.");
    // All formats have floats.
    Mesh rounded = clean.mesh;
    for (Vec3& vertex : rounded.vertices) vertex = vertex.cast<float>().cast<double>();
    std::size_t faults = clean_mesh(rounded).copies;
    for (std::uint32_t i = 0; i < rounded.triangles.size(); ++i)
        faults += is_degenerate(corners(rounded, i));
    if (faults > 0)
        throw InputError("-o: the file rounds coordinates to 32 bits. " +
                         counted(faults, "triangle", "triangles") +
                         " would lose its area or become a copy; move the mesh nearer to its "
                         "origin.");
    return {std::move(clean.mesh), std::move(clean.origin),
            counted(clean.copies, "copy", "copies") + " and " +
                counted(clean.degenerate, "triangle without area", "triangles without area") +
                " left out"};
}

/// Writes the changed mesh of a body.
int run_mesh(const ExportOptions& options, const Console& console) {
    const bool cuts = !options.clean;
    if (cuts && (!(options.cut > 0) || !std::isfinite(options.cut)))
        throw InputError("--cut " + exact_number(options.cut) +
                         ": give the longest side that pieces may have, above 0.");
    const auto check_outputs = [&] {
        check_output(options.output, "-o");
        if (!options.map.empty()) check_output(options.map, "--map");
        if (!options.map.empty() && std::filesystem::weakly_canonical(options.map) ==
                                        std::filesystem::weakly_canonical(options.output))
            throw InputError("--map " + options.map + ": -o names the same file; name another.");
    };
    check_outputs();
    const scenes::Scene scene = options.scene.load(options.scene.frames);
    check_outputs();
    const scenes::Body& body = scene.bodies[changed_body(scene, options.body)];
    const Mesh& mesh = scene.meshes[body.mesh].mesh;
    const ChangedMesh changed = cuts ? cut(mesh, body.name, options) : cleaned(mesh);
    const std::vector<std::uint8_t> bytes =
        scenes::encode_mesh({{body.name, changed.mesh, {0.75f, 0.75f, 0.75f}}}, options.output);
    if (!options.map.empty()) {
        std::string map = std::string("triangle,") + (cuts ? "cut_from" : "original") + "\n";
        for (std::size_t i = 0; i < changed.origin.size(); ++i)
            map += std::to_string(i) + "," + std::to_string(changed.origin[i]) + "\n";
        write_file_whole(options.map, map);
    }
    write_file_whole(options.output, bytes);
    console.note(options.output + ": " +
                 counted(changed.mesh.triangles.size(), "triangle", "triangles") + "; " +
                 changed.words + ".");
    return exit_done;
}

int run(const ExportOptions& options, const Console& console) {
    if (options.levels.empty()) return run_mesh(options, console);
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
        program.add_subcommand("export", "Write a level, or a mesh that is cut or cleaned");
    const auto options = std::make_shared<ExportOptions>();
    add_scene_options(command, options->scene, true);
    add_hierarchy_options(command, options->hierarchy, false);
    command
        .add_option("--levels,--level", options->levels,
                    "The level to write: a number, or 'leaves'")
        .offer({"leaves"})
        .type_name("K");
    command.add_option("--segments", options->segments, "Corners per circle")
        .check(decimal_number)
        .show_default();
    command
        .add_option("--cut", options->cut,
                    "Write the mesh of a body, in its own frame and scaled as in the scene, with "
                    "triangles cut into pieces whose sides are at most so long")
        .type_name("LENGTH");
    command
        .add_option("--triangles", options->triangles,
                    "With --cut: cut these triangles, 12,40:50, and those that share a longer side "
                    "with a cut one. Default: all triangles with a longer side")
        .type_name("LIST");
    command.add_flag("--clean", options->clean,
                     "Write the mesh of a body without triangles that have the corners of another, "
                     "and without triangles whose corners lie on a line");
    command
        .add_option("--body", options->body,
                    "The body whose mesh is written, if the scene has several")
        .type_name("NAME");
    command
        .add_option("--map", options->map,
                    "Also write a table (CSV) of the original triangle of each triangle of the new "
                    "mesh")
        .file({".csv"})
        .only_typed();
    command.add_option("-o,--output", options->output, "The file: .ply, .obj, .glb or .stl")
        .required()
        .file({".ply", ".obj", ".glb", ".stl"})
        .only_typed();
    command.footer(
        "Cutting halves the longest side of a triangle until no side is too long. Neighbors are "
        "cut "
        "at the same points, so a\nclosed mesh stays closed. Triangles that are not cut keep their "
        "numbers. `scb inspect` finds triangles to cut.\n\n"
        "Examples:\n"
        "  scb export spheres-l1 --levels 7 -o level-7.ply\n"
        "  scb export part.stl --cut 0.5 -o part-cut.ply --map part-cut.csv");
    command.callback([&action, &console, command, options] {
        options->recording = given_hierarchy_options(command);
        int ways = 0;
        for (const char* option : {"--levels", "--cut", "--clean"})
            ways += command.count(option) > 0;
        if (ways != 1)
            throw InputError(
                "give one of --levels, the level to write; --cut, the longest side of the pieces "
                "of triangles; and --clean.");
        if (command.count("--cut") == 0 && command.count("--triangles") > 0)
            throw InputError("--triangles has no meaning without --cut.");
        for (const char* option : {"--body", "--map"})
            if (command.count("--levels") > 0 && command.count(option) > 0)
                throw InputError(std::string(option) + " has no meaning with --levels.");
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
