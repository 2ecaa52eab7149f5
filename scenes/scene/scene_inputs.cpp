#include "scenes/scene/scene_inputs.h"

#include <nlohmann/json.hpp>

#include "core/platform/input_files.h"
#include "core/platform/json_reader.h"
#include "scb/error.h"

namespace scb::scenes {
namespace {

namespace fs = std::filesystem;

/// Notes the files that `name` has in the objects of the list `list` of a scene.
void note_files(const nlohmann::json& scene, const char* list, const char* name,
                const std::vector<fs::path>& folders) {
    if (!scene.is_object() || !scene.contains(list)) return;
    for (const nlohmann::json& entry : scene.at(list)) {
        if (!entry.is_object() || !entry.contains(name) || !entry.at(name).is_string()) continue;
        for (const fs::path& folder : folders)
            note_input(folder / entry.at(name).get<std::string>());
    }
}

void note_files_of(const fs::path& scene, const fs::path& models_dir) {
    const nlohmann::json document = parse_json(read_text_file(scene.string()), scene.string());
    const std::vector<fs::path> folders = {scene.parent_path(), models_dir};
    note_files(document, "models", "file", folders);
    note_files(document, "bodies", "poses", folders);
}

}  // namespace

void note_scene_inputs(const std::vector<std::string>& names, const fs::path& models_dir) {
    for (const fs::path name : names) {
        note_input(name);
        note_input(models_dir / name);
        if (name.extension() != ".json") continue;
        try {
            note_files_of(name, models_dir);
        } catch (const InputError&) {
        }
    }
}

}  // namespace scb::scenes
