#include "app/explain_pictures.h"

#include "render/figure_layout.h"

namespace scb {

std::optional<CameraSpec> asked_camera(const CameraOptions& options, const Scene* scene) {
    if ((options.camera.empty() && options.up.empty()) || options.follows_contact())
        return std::nullopt;
    if (scene != nullptr) return camera_spec_for(options, *scene);
    CameraSpec spec;
    if (!options.camera.empty()) spec = parse_camera(options.camera);
    if (!options.up.empty()) spec.up = options.up_vector();
    if (options.orthographic) spec.orthographic = true;
    return spec;
}

void draw_explanation(PictureRun& pictures, const PictureOptions& options,
                      const CameraOptions& camera, const ExplainedPair& pair,
                      const ExplainPicture& picture, nlohmann::ordered_json entry) {
    ExplainFigure figure;
    figure.title = picture.title;
    figure.subtitle = picture.subtitle;
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
    figure.to_world = picture.to_world;
    figure.orthographic = camera.orthographic;
    figure.theme = options.theme();
    const int width = options.width(), height = options.height();
    if (picture.camera) {
        const std::vector<AnyVolume> volumes = {placed(figure.a, figure.to_world),
                                                placed(figure.b, figure.to_world)};
        const PixelRect view = explain_layout(width, height, figure).view_box();
        figure.camera = camera_for(*picture.camera, support_of(volumes), aspect_of(view));
    }
    const Picture composed = compose(figure, width, height, options.samples, pictures.overlay());
    pictures.draw(picture.name, composed, std::move(entry));
}

}  // namespace scb
