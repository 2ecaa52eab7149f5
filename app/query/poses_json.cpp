#include "app/query/poses_json.h"

#include <nlohmann/json.hpp>

#include "scenes/scene/pose_rows.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

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
