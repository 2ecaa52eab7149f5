#include "app/pictures/level_index.h"

#include <nlohmann/json.hpp>

#include "app/pictures/id_ranges.h"
#include "app/report/scene_report.h"
#include "app/report/trace_report.h"
#include "core/model/level_statistics.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

Json level_json(int level) { return level == leaf_level ? Json("leaves") : Json(level); }

}  // namespace

Json level_entry(const std::string& volumes, int level, int frame,
                 const std::vector<render::LevelBody>& bodies, bool ids) {
    const render::LevelNumbers numbers = render::level_numbers(bodies, level);
    Json list = Json::array();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const VolumeStatistics& s = numbers.bodies[b];
        list.push_back({{"body", bodies[b].name},
                        {"first_id", bodies[b].first_id},
                        {"volumes", s.volumes},
                        {"leaves", s.leaves},
                        {"mean_diameter", s.mean_diameter()},
                        {"mean_thickness", s.mean_thickness()},
                        {"area", s.area},
                        {"volume", s.volume}});
        if (!ids) continue;
        if (std::vector<std::uint32_t> by_id = numbers_by_id(*bodies[b].tree); !by_id.empty())
            list.back()["node_numbers"] = std::move(by_id);
    }
    return {{"volume", volumes},
            {"level", level_json(level)},
            {"frame", frame},
            {"bodies", std::move(list)}};
}

Json level_head(const LevelOptions& options, const scenes::Scene& scene,
                const std::vector<std::string>& volumes, int frame, const std::vector<int>& levels,
                const scenes::CameraView& camera) {
    Json levels_json = Json::array();
    for (const int level : levels) levels_json.push_back(level_json(level));
    Json bodies = Json::array();
    for (const scenes::Body& body : scene.bodies)
        bodies.push_back(body_json({body.name, fingerprint(scene.meshes[body.mesh].mesh)}));
    return {{"command", "render levels"},
            {"scene", scene.name},
            {"bodies", std::move(bodies)},
            {"frame", frame},
            {"poses", poses_json(scene, {frame})},
            {"options",
             {{"volume", volumes},
              {"levels", levels_json},
              {"growth", ball_growth_name(options.hierarchy.growth)},
              {"margin", options.hierarchy.margin},
              {"split", split_method_name(options.hierarchy.split)},
              {"size", {options.picture.width(), options.picture.height()}},
              {"samples", options.picture.samples},
              {"background", options.picture.background},
              {"color_by", render::color_by_names[options.resolved_color_by(scene.bodies.size())]},
              {"opacity", options.resolved_opacity()},
              {"mesh", options.mesh},
              {"edges", options.edges}}},
            {"camera", scenes::camera_json(camera)}};
}

}  // namespace scb::app
