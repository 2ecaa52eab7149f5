#include "app/explain/explain_pictures.h"

#include <nlohmann/json.hpp>
#include <span>

#include "core/base/text_format.h"
#include "render/figures/explain_figure.h"
#include "render/overlay/figure_layout.h"
#include "scb/triangle_overlap.h"

namespace scb::app {
namespace {

/// The triangles below a node.
Mesh mesh_below(const BodyAtFrame& body, std::uint32_t node) {
    const TreeShape& shape = body.tree->shape();
    Mesh mesh;
    const auto add = [&](std::span<const std::uint32_t> items) {
        for (const std::uint32_t item : items) {
            if (item >= body.mesh->triangles.size()) continue;
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const Vec3& corner : corners(*body.mesh, item)) mesh.vertices.push_back(corner);
            mesh.triangles.push_back({first, first + 1, first + 2});
        }
    };
    add(body.tree->items(node));
    std::vector<bool> is_below(shape.size());
    is_below[node] = true;
    for (const std::uint32_t i : shape.order)
        if (shape.parents[i] != no_index && is_below[shape.parents[i]]) {
            is_below[i] = true;
            add(body.tree->items(i));
        }
    return mesh;
}

}  // namespace

std::optional<scenes::CameraView> asked_camera(const CameraOptions& options,
                                               const scenes::Scene* scene) {
    if ((options.camera.empty() && options.up.empty()) || options.follows_contact())
        return std::nullopt;
    scenes::CameraView wish;
    if (scene != nullptr) {
        wish = camera_view_for(options, *scene);
    } else {
        if (!options.camera.empty()) wish = scenes::parse_camera(options.camera);
        if (!options.up.empty()) wish.up = options.up_vector();
        if (options.orthographic) wish.orthographic = true;
    }
    wish.clip.reset();  // both volumes are shown whole
    return wish;
}

std::string explain_name(const std::string& stem, const TraceHeader& header,
                         const NamedOptions& named, int frame,
                         const std::array<std::uint32_t, 2>& nodes) {
    std::string which = frame_part(frame);
    for (std::size_t side = 0; side < 2; ++side)
        which += "_" + scenes::file_name_of(header.bodies[side].name) + "-" +
                 std::to_string(nodes[side]);
    return picture_name(stem, volume_file_part(header) + "_explain", named, which);
}

void place_nodes(ExplainPicture& picture, const std::array<BodyAtFrame, 2>& bodies,
                 IndexPair nodes) {
    picture.triangles.emplace();
    for (std::size_t side = 0; side < 2; ++side) {
        picture.to_world[side] = bodies[side].pose;
        (*picture.triangles)[side] = mesh_below(bodies[side], side == 0 ? nodes.a : nodes.b);
    }
    if ((*picture.triangles)[0].triangles.empty() || (*picture.triangles)[1].triangles.empty())
        picture.triangles.reset();
}

void draw_explanation(PictureRun& pictures, const PictureOptions& options,
                      const ExplainedPair& pair, const ExplainPicture& picture,
                      nlohmann::ordered_json entry) {
    render::ExplainFigure figure;
    figure.title = picture.title;
    figure.subtitle = picture.subtitle;
    figure.but = picture.but;
    figure.ending = picture.ending;
    figure.is_tested = picture.is_tested;
    const auto name = [&](std::size_t side) {
        const std::string raw = side == 0 ? "A" : "B";
        if (!pair.nodes) return raw;
        const ExplainedNode& node = (*pair.nodes)[side];
        return node.body + " " + std::to_string(node.index);
    };
    figure.names = {name(0), name(1)};
    figure.kind = pair.kind;
    figure.a = pair.a;
    figure.b = b_seen_from_a(pair);
    figure.options = pair.options;
    figure.found = &pair.found;
    figure.to_world = picture.to_world[0];
    figure.orthographic = picture.orthographic;
    figure.theme = options.theme();
    if (picture.triangles) {
        figure.triangles.emplace();
        for (std::size_t side = 0; side < 2; ++side) {
            render::MeshDraw& mesh = (*figure.triangles)[side];
            mesh.mesh = pictures.renderer().upload((*picture.triangles)[side]);
            mesh.pose = picture.to_world[side];
        }
    }
    const int width = options.width(), height = options.height();
    if (picture.camera) {
        const std::vector<AnyVolume> volumes = {placed(figure.a, figure.to_world),
                                                placed(figure.b, figure.to_world)};
        const render::PixelRect view =
            render::explain_layout(width, height, figure, pictures.overlay()).view_box();
        figure.camera =
            camera_for(*picture.camera, render::support_of(volumes), render::aspect_of(view));
    }
    const render::Picture composed =
        render::compose(figure, width, height, options.samples, pictures.overlay());
    pictures.draw(picture.name, composed, std::move(entry));
    if (figure.triangles)
        for (const render::MeshDraw& mesh : *figure.triangles)
            pictures.renderer().release(mesh.mesh);
}

std::string asked_words(const ExplainedPair& pair) {
    if (pair.kind != VolumeKind::scb) return "";
    return "test " + overlap_title(pair.options);
}

nlohmann::ordered_json explain_index_head(const ExplainOptions& options) {
    nlohmann::ordered_json head = {{"command", "explain"}};
    head["source"] = utf8_names(options.pairs_file.empty() ? options.scene.names
                                                           : std::vector{options.pairs_file});
    head["options"] = {{"test", options.query.test},
                       {"threshold", options.query.threshold},
                       {"size", {options.picture.width(), options.picture.height()}},
                       {"samples", options.picture.samples},
                       {"background", options.picture.background}};
    return head;
}

}  // namespace scb::app
