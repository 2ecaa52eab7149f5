#include "app/explain/explain_pictures.h"

#include <nlohmann/json.hpp>

#include "core/base/text_format.h"
#include "core/hierarchy/node_mesh.h"
#include "render/figures/explain_layout.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {

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
    return picture_name(stem, std::string(volume_kind_name(header.volume)) + "_explain", named,
                        which);
}

void place_nodes(ExplainPicture& picture, const SceneQuery& query, int frame,
                 const ExplainedPair& pair) {
    const std::size_t bodies[] = {query.a, query.b};
    picture.triangles.emplace();
    for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t body = bodies[side];
        picture.to_world[side] = scenes::pose_at(query.scene.bodies[body].motion, frame);
        (*picture.triangles)[side] = node_mesh(query.mesh(body), topology_of(query.hierarchy(body)),
                                               (*pair.nodes)[side].index);
    }
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
        const std::vector<render::AnyVolume> volumes = {render::placed(figure.a, figure.to_world),
                                                        render::placed(figure.b, figure.to_world)};
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
