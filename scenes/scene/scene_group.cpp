#include "scenes/scene/scene_group.h"

#include <algorithm>

#include "scb/error.h"
#include "scenes/scene/builtin.h"

namespace scb::scenes {

const SceneGroup* find_scene_group(std::string_view name) {
    for (const SceneGroup& group : scene_groups)
        if (group.name == name) return &group;
    return nullptr;
}

bool has_scene(const SceneGroup& group, std::string_view name) {
    return std::find(group.scenes.begin(), group.scenes.end(), name) != group.scenes.end();
}

MeasuredScenes measured_scenes(const std::vector<std::string>& names,
                               const std::vector<std::string>& defaults,
                               const std::filesystem::path& models_dir) {
    MeasuredScenes result;
    const auto add_where_there = [&](std::string_view name) {
        const std::string file = missing_mesh_file(*find_builtin(name), models_dir);
        if (file.empty())
            result.names.emplace_back(name);
        else
            result.left_out.push_back(
                std::string(name) + " is left out: it needs " + file +
                "; name the folder that holds it with --models DIR or SCB_MODELS.");
    };
    for (const std::string& name : names.empty() ? defaults : names) {
        if (const SceneGroup* group = find_scene_group(name))
            for (const std::string_view scene : group->scenes) add_where_there(scene);
        else if (names.empty())
            add_where_there(name);
        else
            result.names.push_back(name);
    }
    if (result.names.empty())
        throw InputError("there is no scene to measure: " + result.left_out.front());
    return result;
}

}  // namespace scb::scenes
