#include "app/golden/init_camera.h"

#include "app/pictures/query_view.h"
#include "core/base/text_format.h"

namespace scb::app {

std::vector<std::string> seeing_camera_words(const SceneOptions& scene, const std::string& bodies,
                                             int frame, const std::string& size) {
    QueryViewOptions options;
    options.scene = scene;
    options.query.bodies = bodies;
    options.query.frames = std::to_string(frame);
    options.picture.size = size;
    options.picture.no_panel = true;
    const QuerySources sources = open_sources(scene, options.hierarchy, options.query,
                                              options.limits, {}, [](const std::string&) {});
    render::Context context(options.picture.backend());
    render::Renderer renderer(context);
    const QueryView view(options, sources, renderer);
    const auto& sought = view.sought();
    const scenes::CameraView usual = camera_view_for(options.camera, sources.front().scene());
    if (!sought || (sought->direction.azimuth == usual.azimuth &&
                    sought->direction.elevation == usual.elevation))
        return {};
    return {"--camera", "orbit:" + exact_number(sought->direction.azimuth) + "," +
                            exact_number(sought->direction.elevation)};
}

}  // namespace scb::app
