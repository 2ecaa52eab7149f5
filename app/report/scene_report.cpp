#include "app/report/scene_report.h"

#include <nlohmann/json.hpp>

#include "core/platform/utf8.h"
#include "scenes/scene/pose_rows.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string bodies_text(const TraceHeader& header) {
    const auto [a, b] = body_names(header);
    return printable(header.kind == QueryKind::self ? a + " against itself" : a + " and " + b);
}

std::string scene_title(const std::string& scene, const std::string& a, const std::string& b) {
    const std::string mesh = a.substr(0, a.rfind("-A"));
    const bool twice = mesh + "-A" == a && mesh + "-B" == b && scene == mesh + "-" + mesh;
    return printable(twice ? mesh + " with itself" : scene);
}

std::string scene_title(const TraceHeader& header) {
    const auto [a, b] = body_names(header);
    const std::string selection = header.engine ? header.engine->selection : "";
    return scene_title(header.scene, a, b) +
           (header.kind == QueryKind::self ? " against itself" : "") +
           (selection.empty() ? "" : " · " + printable(selection));
}

Json pose_json(const Pose& pose) { return scenes::rows_of(pose); }

Json poses_json(const scenes::Scene& scene, const std::vector<int>& frames) {
    if (frames.empty()) return Json::object();
    return all_poses_json(scene, {frames.front(), frames.back()});
}

Json all_poses_json(const scenes::Scene& scene, const std::vector<int>& frames) {
    Json poses = Json::object();
    for (const int frame : frames)
        for (const scenes::Body& body : scene.bodies)
            poses[std::to_string(frame)][body.name] =
                pose_json(scenes::pose_at(body.motion, frame));
    return poses;
}

}  // namespace scb::app
