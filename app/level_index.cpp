#include "app/level_index.h"

#include "app/version.h"

namespace scb {
namespace {

using Json = nlohmann::ordered_json;

Json level_json(int level) { return level == leaf_level ? Json("leaves") : Json(level); }

}  // namespace

void LevelIndex::add_level(const std::string& file, const std::string& ids_file, VolumeKind kind,
                           int level, int frame, const std::vector<LevelBody>& bodies) {
    const LevelNumbers numbers = level_numbers(bodies, level);
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
    }
    Json entry = {{"file", file}};
    if (!ids_file.empty()) entry["ids"] = ids_file;
    entry["volume"] = volume_kind_name(kind);
    entry["level"] = level_json(level);
    entry["frame"] = frame;
    entry["bodies"] = std::move(list);
    files.push_back(std::move(entry));
}

void LevelIndex::add_sheet(const std::string& file) {
    files.push_back({{"file", file}, {"sheet", true}});
}

std::string LevelIndex::text(const LevelOptions& options, const Scene& scene, int frame,
                             const std::vector<int>& levels, const CameraSpec& camera,
                             const GlInfo& gl) const {
    Json versions_json, levels_json = Json::array(), kinds = Json::array();
    for (const auto& [name, version] : versions(&gl)) versions_json[name] = version;
    for (const int level : levels) levels_json.push_back(level_json(level));
    for (const VolumeKind kind : options.hierarchy.kinds()) kinds.push_back(volume_kind_name(kind));
    const Json index = {
        {"command", "render levels"},
        {"scene", scene.name},
        {"frame", frame},
        {"options",
         {{"volume", kinds},
          {"levels", levels_json},
          {"growth", options.hierarchy.growth},
          {"margin", options.hierarchy.margin},
          {"size", {options.picture.width(), options.picture.height()}},
          {"samples", options.picture.samples},
          {"background", options.picture.background},
          {"color_by", color_by_name(options.resolved_color_by(scene.bodies.size()))},
          {"opacity", options.resolved_opacity()},
          {"mesh", options.mesh},
          {"edges", options.edges}}},
        {"camera", Json::parse(camera_json(camera))},
        {"versions", versions_json},
        {"files", files}};
    // File names and names in scene files need not be UTF-8.
    return index.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace scb
