#include "app/query/poses_json.h"

#include <nlohmann/json.hpp>

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json pose_json(const Pose& pose) {
    Json numbers = Json::array();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) numbers.push_back(pose.rotation(row, column));
        numbers.push_back(pose.translation[row]);
    }
    return numbers;
}

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
