#include "app/view/view_manifest.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/pictures/level_bodies.h"
#include "core/model/level_statistics.h"
#include "core/platform/utf8.h"
#include "core/volumes/convex_shape.h"
#include "render/figures/query_body.h"
#include "render/web/tree_blocks.h"

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

Json clip_json(const std::optional<FacePlane>& clip) {
    if (!clip) return nullptr;
    return {{"normal", json_of(clip->normal)}, {"offset", clip->offset}};
}

Json camera_json(const ViewStart& start) {
    const render::Camera& camera = start.camera;
    return {{"position", json_of(camera.position)}, {"axes", json_of(camera.axes)},
            {"orthographic", camera.orthographic},  {"fov", camera.vertical_fov},
            {"view_height", camera.view_height},    {"aspect", start.aspect},
            {"center", json_of(start.center)},      {"clip", clip_json(camera.clip)}};
}

/// Vertices are relative to the middle of the mesh, so that 32 bits suffice.
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

/// The largest distance of the tree from `center`.
double reach_of(const Tree& tree, const Vec3& center) {
    double most = 0;
    for (const std::uint32_t root : tree.shape().roots)
        if (tree.has_volume(root)) {
            const Vec3 away = scb::center(tree.volume(root)) - center;
            most = std::max(most, std::sqrt(squared_norm(away)) + tree.lengths(root).diameter / 2);
        }
    return most;
}

/// The names of the nodes that have one, by their indices.
Json names_json(const Tree& tree) {
    Json names = Json::object();
    for (std::uint32_t node = 0; node < tree.size(); ++node)
        if (const std::string name = tree.name(node); !name.empty())
            names[std::to_string(node)] = printable(name);
    return names;
}

Json tree_json(const Tree& tree, const render::ColorScale& scale, std::size_t body,
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
    Json levels = Json::array();
    for (const VolumeStatistics& level : cover_statistics(tree))
        levels.push_back({level.volumes, level.mean_diameter(), level.mean_thickness(), level.area,
                          level.volume});
    Json told = {{"center", json_of(blocks.center)},
                 {"radius", reach_of(tree, blocks.center)},
                 {"levels", std::move(levels)},
                 {"nodes", tree.size()},
                 {"order", blocks.order},
                 {"children", blocks.children},
                 {"item_counts", blocks.item_counts},
                 {"items", blocks.items},
                 {"counts", blocks.counts},
                 {"parts", std::move(parts)}};
    if (blocks.numbers) told["numbers"] = *blocks.numbers;
    if (const Json names = names_json(tree); !names.empty())
        told["names"] = store.add(std::string_view(names.dump()));
    return told;
}

/// Stores data that columns share only once.
class Parts {
  public:
    Parts(const ViewSubject& subject, const ViewStart& start, render::BlockStore& store)
        : subject_(subject), start_(start), store_(store) {}

    Json body(const ViewColumn& column, std::size_t b, std::uint32_t first_id) {
        const BodyAtFrame& body = column.bodies[b];
        Json told = {{"name", printable(body.name)},
                     {"color", color_json(render::category_color(b))},
                     {"dimmed",
                      {{"light", color_json(render::dimmed_body_color(b, render::light_theme))},
                       {"dark", color_json(render::dimmed_body_color(b, render::dark_theme))}}},
                     {"first_id", first_id},
                     {"mesh", nullptr},
                     {"tree", tree(*body.tree, b)},
                     {"poses", poses(column, b)}};
        if (!body.mesh->triangles.empty()) told["mesh"] = mesh(*body.mesh);
        return told;
    }

    Json meshes = Json::array(), trees = Json::array();

  private:
    /// The index of an entry in the list; adds the entry if it is missing.
    static std::size_t place_of(Json& list, Json entry) {
        const auto known = std::find(list.begin(), list.end(), entry);
        if (known != list.end()) return static_cast<std::size_t>(known - list.begin());
        list.push_back(std::move(entry));
        return list.size() - 1;
    }

    std::size_t mesh(const Mesh& mesh) {
        const auto [place, is_new] = mesh_places_.try_emplace(&mesh);
        if (is_new) place->second = place_of(meshes, mesh_json(mesh, store_));
        return place->second;
    }

    /// With colors by body, each body has its own copy of a hierarchy.
    std::size_t tree(const Tree& tree, std::size_t b) {
        const render::ColorScale& scale = start_.style.colors;
        const auto [place, is_new] =
            tree_places_.try_emplace({&tree, scale.by == render::ColorBy::body ? b : 0});
        if (is_new) place->second = place_of(trees, tree_json(tree, scale, b, store_));
        return place->second;
    }

    /// The poses at all frames, twelve numbers each: the rows of a 3x4 matrix.
    std::size_t poses(const ViewColumn& column, std::size_t b) {
        std::vector<double> rows;
        for (const int frame : subject_.frames) {
            const Pose pose = column.is_recorded()
                                  ? column.bodies[b].pose
                                  : pose_at(column.scene->bodies[column.places[b]].motion, frame);
            for (int i = 0; i < 3; ++i) {
                for (int k = 0; k < 3; ++k) rows.push_back(pose.rotation(i, k));
                rows.push_back(pose.translation[i]);
            }
        }
        return store_.add(rows);
    }

    const ViewSubject& subject_;
    const ViewStart& start_;
    render::BlockStore& store_;
    std::map<const Mesh*, std::size_t> mesh_places_;                          // lookups only
    std::map<std::pair<const Tree*, std::size_t>, std::size_t> tree_places_;  // lookups only
};

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

/// Corners of triangles whose directions cover the sphere, one after the other: coarse, medium and
/// fine grids for few, some and many rounded volumes, as in ConvexPoints.
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

Json view_manifest(const ViewSubject& subject, const ViewStart& start, render::BlockStore& store) {
    Parts parts(subject, start, store);
    Json columns = Json::array();
    for (const ViewColumn& column : subject.columns) {
        Json bodies = Json::array();
        const std::vector<render::LevelBody> level = level_bodies(column.bodies, {});
        for (std::size_t b = 0; b < level.size(); ++b)
            bodies.push_back(parts.body(column, b, level[b].first_id));
        columns.push_back({{"title", printable(column.title)},
                           {"bodies", std::move(bodies)},
                           {"verdict", column.verdict},
                           {"explain", column.explain},
                           {"several_frames", column.scene->frames > 1},
                           {"query", nullptr}});
    }
    const auto at = std::find(subject.frames.begin(), subject.frames.end(), subject.frame);
    return {
        {"scb_view", 1},
        {"scene", subject.columns.front().scene->name},
        {"commands", start.commands},
        {"frames", subject.frames},
        {"same_nodes", subject.same_nodes},
        {"up", json_of(start.up)},
        {"columns", std::move(columns)},
        {"meshes", std::move(parts.meshes)},
        {"trees", std::move(parts.trees)},
        {"grids", add_grids(store)},
        {"legend", legend_json(start.style.colors)},
        {"viridis", viridis_json()},
        {"camera", camera_json(start)},
        {"themes",
         {{"light", theme_json(render::light_theme)}, {"dark", theme_json(render::dark_theme)}}},
        {"start",
         {{"level", start.level},
          {"at", at - subject.frames.begin()},
          {"opacity", start.style.opacity},
          {"mesh", start.style.mesh},
          {"edges", start.style.mesh_edges}}}};
}

}  // namespace scb::app
