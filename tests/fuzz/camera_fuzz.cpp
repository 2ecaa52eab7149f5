#include <nlohmann/json.hpp>

#include "scenes/scene/camera_view.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

SCB_FUZZ(input) {
    try {
        const scenes::CameraView camera =
            scenes::parse_camera_json(std::string(input.begin(), input.end()), "input");
        const std::string once = scenes::camera_json(camera).dump();
        const scenes::CameraView again = scenes::parse_camera_json(once, "again");
        fuzz::require(scenes::camera_json(again).dump() == once, "a camera is read back");
    } catch (const InputError& error) {
        fuzz::require_sentence(error, "input");
    }
}
