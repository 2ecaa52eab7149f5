#include <algorithm>

#include "scenes/scene/scene_file.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

SCB_FUZZ(input) {
    const std::string text(input.begin(), input.end());
    // Meshes of millions of triangles are legal, and take their time.
    std::size_t digits = 0;
    for (const char c : text) {
        digits = c >= '0' && c <= '9' ? digits + 1 : 0;
        if (digits > 2) return;
    }
    if (text.find_first_of("eE") != text.npos && digits > 0) return;
    try {
        const scenes::Scene scene = scenes::parse_scene(text, {"input", "/nowhere", ""});
        for (const scenes::Body& body : scene.bodies) {
            fuzz::require(body.mesh < scene.meshes.size(), "bodies have meshes");
            check_rigid(scenes::pose_at(body.motion, scene.frames - 1), "a pose");
        }
    } catch (const InputError& error) {
        fuzz::require_sentence(error, "input");
    }
}
