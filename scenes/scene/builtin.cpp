#include "scenes/scene/builtin.h"

#include <nlohmann/json.hpp>

#include "scenes/scene/scene_file.h"
#include "scenes/text/json_reader.h"

// Made by scb_embed from scenes/builtin/*.json; the list in scenes/CMakeLists.txt is the same.
#define SCB_FOR_EACH_BUILTIN(X) \
    X(spheres_l1)               \
    X(spheres_l2)               \
    X(knots_l1)                 \
    X(knots_l2)                 \
    X(knots_l3)                 \
    X(horses)                   \
    X(hands)                    \
    X(dragons)                  \
    X(aatbase)                  \
    X(tray_bottom)              \
    X(boeing)                   \
    X(cheese)                   \
    X(tr12j)                    \
    X(anchor)                   \
    X(cycloidal)                \
    X(tube)                     \
    X(flat_plate)               \
    X(concentric_spheres)       \
    X(thin_cylinder)            \
    X(cone)                     \
    X(soup)                     \
    X(line_8)                   \
    X(lines_20_23)              \
    X(long_triangles)

extern "C" {
#define SCB_DECLARE(symbol)                    \
    extern const char scb_embedded_##symbol[]; \
    extern const char scb_embedded_##symbol##_end[];
SCB_FOR_EACH_BUILTIN(SCB_DECLARE)
#undef SCB_DECLARE
}

namespace scb::scenes {
namespace {

BuiltinScene summary(const char* begin, const char* end) {
    const std::string_view text(begin, static_cast<std::size_t>(end - begin));
    const nlohmann::json document = parse_json(text, "a built-in scene");
    const JsonPlace root{&document, "a built-in scene", ""};
    BuiltinScene scene{read_text(field(root, "name")),
                       read_text(field(root, "description")),
                       text,
                       static_cast<int>(read_integer(field(root, "frames"), 1, 1'000'000)),
                       {}};
    const JsonPlace models = field(root, "models");
    for (std::size_t i = 0; i < array_size(models, "a list of models"); ++i)
        if (has(element(models, i), "file"))
            scene.mesh_files.push_back(read_text(field(element(models, i), "file")));
    return scene;
}

}  // namespace

const std::vector<BuiltinScene>& builtin_scenes() {
    static const std::vector<BuiltinScene> scenes = {
#define SCB_ENTRY(symbol) summary(scb_embedded_##symbol, scb_embedded_##symbol##_end),
        SCB_FOR_EACH_BUILTIN(SCB_ENTRY)
#undef SCB_ENTRY
    };
    return scenes;
}

const BuiltinScene* find_builtin(std::string_view name) {
    for (const BuiltinScene& scene : builtin_scenes())
        if (scene.name == name) return &scene;
    return nullptr;
}

std::string missing_mesh_file(const BuiltinScene& scene, const std::filesystem::path& models_dir) {
    for (const std::string& file : scene.mesh_files) {
        std::error_code ignored;
        if (models_dir.empty() || !std::filesystem::exists(models_dir / file, ignored)) return file;
    }
    return {};
}

Scene load_builtin(const BuiltinScene& scene, const std::filesystem::path& models_dir) {
    return parse_scene(scene.json, {"built-in " + scene.name, {}, models_dir});
}

}  // namespace scb::scenes
