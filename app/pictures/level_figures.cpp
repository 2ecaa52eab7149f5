#include "app/pictures/level_figures.h"

#include <map>

#include "app/pictures/level_bodies.h"
#include "app/pictures/scene_camera.h"
#include "app/report/build_text.h"

namespace scb::app {
namespace {

// The frame, and every option that affects the picture but cannot be seen in it.
std::string subtitle_of(const LevelOptions& options, const LevelSubject& subject,
                        const render::Camera& camera) {
    const scenes::Scene& scene = subject.scene;
    std::string text = "of levels 0 to " + std::to_string(subject.deepest);
    if (scene.frames > 1)
        text += ", frame " + std::to_string(subject.frame) + " of 0 to " +
                std::to_string(scene.frames - 1);
    if (!subject.recorded) text += build_text(options.hierarchy.build());
    if (camera.orthographic) text += ", orthographic";
    if (camera.clip) text += ", clipped";
    const std::string up = up_words(options.camera, scene);
    if (!up.empty()) text += ", " + up;
    return text;
}

std::vector<render::MeshHandle> uploaded(const std::vector<BodyAtFrame>& bodies,
                                         render::Renderer& renderer) {
    std::vector<render::MeshHandle> handles;
    std::map<const Mesh*, render::MeshHandle> known;  // lookups only
    for (const BodyAtFrame& body : bodies) {
        const auto [handle, is_new] = known.try_emplace(body.mesh.get());
        if (is_new) handle->second = renderer.upload(*body.mesh);
        handles.push_back(handle->second);
    }
    return handles;
}

/// Scans of more triangles have levels that look like them, and take much memory to draw.
constexpr std::size_t most_small_triangles = 200'000;

std::size_t triangles_of(const std::vector<BodyAtFrame>& bodies) {
    std::size_t count = 0;
    for (const BodyAtFrame& body : bodies) count += body.mesh->triangles.size();
    return count;
}

}  // namespace

std::string level_title(int level) {
    return level == leaf_level ? "leaves" : "level " + std::to_string(level);
}

LevelFigures::LevelFigures(const LevelOptions& options, const LevelSubject& subject,
                           render::Renderer& renderer)
    : subject_(subject), wish_(camera_view_for(options.camera, subject.scene)) {
    const std::vector<LevelTrees>& trees = subject.trees;
    common_.style = level_style(options, trees[0].bodies, subject.deepest);
    std::vector<render::MeshHandle> handles;
    const std::size_t triangles = triangles_of(trees[0].bodies);
    const bool shows_meshes = !options.picture.no_panel && !wish_.inset && !common_.style.mesh &&
                              triangles > 0 && triangles <= most_small_triangles;
    if (common_.style.mesh || shows_meshes) handles = uploaded(trees[0].bodies, renderer);
    for (const LevelTrees& each : trees) bodies_.push_back(level_bodies(each.bodies, handles));
    support_ = support_of(subject.levels);
    common_.center = render::center_of(support_);
    common_.with_panel = !options.picture.no_panel;
    if (wish_.inset)
        common_.detail = render::Detail{detail_camera(wish_, *wish_.inset, support_, 1),
                                        wish_.inset->center, wish_.inset->radius};
    common_.camera = camera_for(wish_, support_, render::aspect_of(options.picture.layout().view));
    if (shows_meshes)
        common_.camera_of_meshes = [this](double aspect) {
            return camera_for(wish_, support_, aspect);
        };
    common_.subtitle = subtitle_of(options, subject, common_.camera);
}

render::Support LevelFigures::support_of(const std::vector<int>& levels) const {
    std::vector<render::Support> of_kinds;
    for (const auto& bodies : bodies_)
        of_kinds.push_back(render::support_of_levels(bodies, levels));
    return render::support_of_all(std::move(of_kinds));
}

render::LevelFigure LevelFigures::figure(std::size_t kind, int level) const {
    render::LevelFigure figure = common_;
    figure.title =
        subject_.scene.name + " · " + subject_.trees[kind].title + " · " + level_title(level);
    figure.bodies = bodies_[kind];
    figure.level = level;
    return figure;
}

}  // namespace scb::app
