#include "app/view/view_manifest.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "app/pictures/level_bodies.h"
#include "core/volumes/direction_grid.h"
#include "render/figures/query_body.h"
#include "render/web/tree_blocks.h"
#include "scenes/text/utf8.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v) { return {v[0], v[1], v[2]}; }
Json json_of(const Mat3& axes) {
    return {json_of(Vec3(axes.col(0))), json_of(Vec3(axes.col(1))), json_of(Vec3(axes.col(2)))};
}

Json theme_json(const render::Theme& theme) {
    return {{"background", color_json(theme.background)},
            {"text", color_json(theme.text)},
            {"faint", color_json(theme.faint_text)},
            {"mesh", color_json(theme.mesh)}};
}

Json camera_json(const ViewStart& start) {
    const render::Camera& camera = start.camera;
    return {{"position", json_of(camera.position)}, {"axes", json_of(camera.axes)},
            {"orthographic", camera.orthographic},  {"fov", camera.vertical_fov},
            {"view_height", camera.view_height},    {"aspect", start.aspect},
            {"center", json_of(start.center)}};
}

/// Vertices count from the middle of the mesh, so that 32 bits are enough.
Json mesh_json(const Mesh& mesh, render::BlockStore& store) {
    const Box box = bounding_box(mesh);
    const Vec3 center = 0.5 * (box.lower + box.upper);
    std::vector<float> positions;
    positions.reserve(3 * mesh.vertices.size());
    for (const Vec3& vertex : mesh.vertices)
        for (int i = 0; i < 3; ++i) positions.push_back(static_cast<float>(vertex[i] - center[i]));
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles)
        indices.insert(indices.end(), triangle.begin(), triangle.end());
    return {{"center", json_of(center)},
            {"triangles", mesh.triangles.size()},
            {"positions", store.add(positions)},
            {"indices", store.add(indices)}};
}

/// The farthest that anything of the tree is from `center`.
double reach_of(const VolumeTree& tree, const Vec3& center) {
    double most = 0;
    for (const std::uint32_t root : tree.shape().roots)
        if (tree.has_volume(root)) {
            const Vec3 away = scb::center(tree.volume(root)) - center;
            most = std::max(most, std::sqrt(squared_norm(away)) + tree.lengths(root).diameter / 2);
        }
    return most;
}

Json tree_json(const VolumeTree& tree, const render::ColorScale& scale, std::size_t body,
               render::BlockStore& store) {
    std::vector<std::uint8_t> subtrees;
    if (scale.by == render::ColorBy::subtree) subtrees = render::subtrees_of(tree.shape());
    const auto color = [&](std::uint32_t node) {
        return render::volume_color(scale,
                                    tree.has_volume(node) ? tree.lengths(node) : VolumeLengths{},
                                    static_cast<int>(tree.shape().depths[node]),
                                    subtrees.empty() ? body : subtrees[node], node);
    };
    const render::TreeBlocks blocks = render::tree_blocks(tree, color, store);
    Json parts = Json::array();
    for (const render::LevelBlocks& part : blocks.parts) {
        Json entry = {{"levels", part.levels},
                      {"shapes", part.shapes},
                      {"numbers", part.numbers},
                      {"colors", part.colors}};
        if (part.has_extras) entry.update({{"extras", part.extras}, {"texels", part.texels}});
        parts.push_back(std::move(entry));
    }
    return {{"center", json_of(blocks.center)},
            {"radius", reach_of(tree, blocks.center)},
            {"nodes", tree.size()},
            {"order", blocks.order},
            {"children", blocks.children},
            {"item_counts", blocks.item_counts},
            {"items", blocks.items},
            {"counts", blocks.counts},
            {"parts", std::move(parts)}};
}

/// The poses of a body at the frames, twelve numbers each: the rows of a 3x4 matrix.
std::size_t add_poses(const LevelSubject& subject, std::size_t body, const std::vector<int>& frames,
                      render::BlockStore& store) {
    std::vector<double> rows;
    for (const int frame : frames) {
        const Pose pose = subject.recorded ? subject.trees[0].bodies[body].pose
                                           : pose_at(subject.scene.bodies[body].motion, frame);
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) rows.push_back(pose.rotation(i, k));
            rows.push_back(pose.translation[i]);
        }
    }
    return store.add(rows);
}

/// Recorded trees are those of one frame.
std::vector<int> frames_of(const LevelSubject& subject) {
    if (subject.recorded) return {subject.frame};
    if (!subject.scene.listed.empty()) return subject.scene.listed;
    std::vector<int> frames(static_cast<std::size_t>(subject.scene.frames));
    std::iota(frames.begin(), frames.end(), 0);
    return frames;
}

Json legend_json(const render::ColorScale& scale) {
    const std::optional<render::PanelScale> legend = render::legend_of(scale);
    if (!legend) return nullptr;
    Json ticks = Json::array();
    for (const auto& [at, text] : legend->ticks) ticks.push_back({at, text});
    return {{"title", legend->title}, {"ticks", ticks}};
}

/// The colors of magnitudes from 0 to 1, in even steps.
Json viridis_json() {
    Json stops = Json::array();
    constexpr int steps = 60;  // the stops of the palette are among them
    for (int i = 0; i <= steps; ++i)
        stops.push_back(color_json(render::viridis(static_cast<double>(i) / steps)));
    return stops;
}

/// Corners of triangles whose directions cover the sphere, one after the other: for few, some and
/// many rounded volumes, as ConvexPoints has them.
Json add_grids(render::BlockStore& store) {
    Json grids = Json::array();
    for (const int steps : {12, 6, 2}) {
        const DirectionGrid grid = direction_grid(steps);
        std::vector<float> corners;
        for (const auto& triangle : grid.triangles)
            for (const std::uint32_t corner : triangle)
                for (int i = 0; i < 3; ++i)
                    corners.push_back(static_cast<float>(grid.directions[corner][i]));
        grids.push_back(store.add(corners));
    }
    return grids;
}

}  // namespace

Json color_json(render::Rgba8 color) { return {color.r, color.g, color.b}; }

Json view_manifest(const LevelSubject& subject, const ViewStart& start, render::BlockStore& store) {
    const std::vector<int> frames = frames_of(subject);
    Json kinds = Json::array(), bodies = Json::array(), meshes = Json::array(),
         trees = Json::array();
    for (const LevelTrees& kind : subject.trees)
        kinds.push_back({{"name", kind.name}, {"title", scenes::printable(kind.title)}});
    std::map<const Mesh*, std::size_t> mesh_places;  // lookups only
    // Colors by body make the same hierarchy another one for each body.
    const bool by_body = start.style.colors.by == render::ColorBy::body;
    std::map<std::pair<const VolumeTree*, std::size_t>, std::size_t> tree_places;  // lookups only
    const std::vector<render::LevelBody> level = level_bodies(subject.trees[0].bodies, {});
    for (std::size_t b = 0; b < level.size(); ++b) {
        const scenes::BodyAtFrame& body = subject.trees[0].bodies[b];
        Json of_body = {{"name", scenes::printable(body.name)},
                        {"color", color_json(render::category_color(b))},
                        {"dimmed",
                         {{"light", color_json(render::dimmed_body_color(b, render::light_theme))},
                          {"dark", color_json(render::dimmed_body_color(b, render::dark_theme))}}},
                        {"first_id", level[b].first_id},
                        {"mesh", nullptr},
                        {"trees", Json::array()},
                        {"poses", add_poses(subject, b, frames, store)}};
        if (!body.mesh->triangles.empty()) {
            const auto [place, is_new] = mesh_places.try_emplace(body.mesh.get(), meshes.size());
            if (is_new) meshes.push_back(mesh_json(*body.mesh, store));
            of_body["mesh"] = place->second;
        }
        for (const LevelTrees& kind : subject.trees) {
            const VolumeTree& tree = *kind.bodies[b].tree;
            const auto [place, is_new] =
                tree_places.try_emplace({&tree, by_body ? b : 0}, trees.size());
            if (is_new) trees.push_back(tree_json(tree, start.style.colors, b, store));
            of_body["trees"].push_back(place->second);
        }
        bodies.push_back(std::move(of_body));
    }
    const auto at = std::find(frames.begin(), frames.end(), subject.frame);
    return {
        {"scb_view", 1},
        {"scene", subject.scene.name},
        {"commands", start.commands},
        {"frames", frames},
        {"up", json_of(start.up)},
        {"bodies", std::move(bodies)},
        {"kinds", std::move(kinds)},
        {"meshes", std::move(meshes)},
        {"trees", std::move(trees)},
        {"grids", add_grids(store)},
        {"legend", legend_json(start.style.colors)},
        {"viridis", viridis_json()},
        {"camera", camera_json(start)},
        {"themes",
         {{"light", theme_json(render::light_theme)}, {"dark", theme_json(render::dark_theme)}}},
        {"start",
         {{"level", start.level},
          {"at", at == frames.end() ? 0 : at - frames.begin()},
          {"opacity", start.style.opacity},
          {"mesh", start.style.mesh},
          {"edges", start.style.mesh_edges},
          {"theme", start.style.theme == &render::dark_theme ? "dark" : "light"}}}};
}

}  // namespace scb::app
