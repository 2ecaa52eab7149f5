#include "app/explain_pictures.h"

#include "app/text_format.h"
#include "render/explain_layout.h"
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

void draw_explanation(PictureRun& pictures, const ExplainOptions& options,
                      const ExplainedPair& pair, const ExplainPicture& picture,
                      nlohmann::ordered_json entry) {
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
    figure.orthographic = options.camera.orthographic;
    figure.theme = options.picture.theme();
    const int width = options.picture.width(), height = options.picture.height();
    if (picture.camera) {
        const std::vector<AnyVolume> volumes = {placed(figure.a, figure.to_world),
                                                placed(figure.b, figure.to_world)};
        const PixelRect view = explain_layout(width, height, figure).view_box();
        figure.camera = camera_for(*picture.camera, support_of(volumes), aspect_of(view));
    }
    const Picture composed =
        compose(figure, width, height, options.picture.samples, pictures.overlay());
    pictures.draw(picture.name, composed, std::move(entry));
}

std::string asked_words(const ExplainedPair& pair) {
    if (pair.kind != VolumeKind::scb) return "";
    const OverlapOptions& asked = pair.options;
    std::string text = "test " + std::string(overlap_test_name(asked.test));
    if (has_threshold(asked.test)) text += format(", threshold %g", asked.threshold);
    return text;
}

nlohmann::ordered_json explain_index_head(const ExplainOptions& options) {
    nlohmann::ordered_json head = {{"command", "explain"}};
    head["options"] = {{"test", options.query.test},
                       {"threshold", options.query.threshold},
                       {"size", {options.picture.width(), options.picture.height()}},
                       {"samples", options.picture.samples},
                       {"background", options.picture.background}};
    return head;
}

}  // namespace scb
