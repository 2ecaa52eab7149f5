#include "app/query/poses_json.h"

#include <nlohmann/json.hpp>

#include "scenes/scene/pose_rows.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json pose_json(const Pose& pose) { return scenes::rows_of(pose); }

Json poses_json(const scenes::Scene& scene, const std::vector<int>& frames) {
    Json poses = Json::object();
    if (frames.empty()) return poses;
    for (const int frame : {frames.front(), frames.back()})
        for (const scenes::Body& body : scene.bodies)
            poses[std::to_string(frame)][body.name] =
                pose_json(scenes::pose_at(body.motion, frame));
    return poses;
}

}  // namespace scb::app
