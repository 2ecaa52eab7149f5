#include "scenes/scene/scene_inputs.h"

#include <nlohmann/json.hpp>

#include "core/platform/input_files.h"
#include "core/platform/json_reader.h"
#include "scb/error.h"

namespace scb::scenes {
namespace {

namespace fs = std::filesystem;

void note_meshes_of(const fs::path& scene, const fs::path& models_dir) {
    const nlohmann::json document = parse_json(read_text_file(scene.string()), scene.string());
    if (!document.is_object() || !document.contains("models")) return;
    for (const nlohmann::json& model : document.at("models")) {
        if (!model.is_object() || !model.contains("file") || !model.at("file").is_string())
            continue;
        const fs::path mesh = model.at("file").get<std::string>();
        note_input(scene.parent_path() / mesh);
        note_input(models_dir / mesh);
    }
}

}  // namespace

void note_scene_inputs(const std::vector<std::string>& names, const fs::path& models_dir) {
    for (const fs::path name : names) {
        note_input(name);
        note_input(models_dir / name);
        if (name.extension() != ".json") continue;
        try {
            note_meshes_of(name, models_dir);
        } catch (const InputError&) {
        }
    }
}

}  // namespace scb::scenes
