#include "scenes/scene/load_scene.h"

#include <algorithm>

#include "core/base/text_format.h"
#include "core/platform/near_word.h"
#include "core/platform/utf8.h"
#include "scb/error.h"
#include "scenes/meshes/mesh_file.h"
#include "scenes/scene/builtin.h"
#include "scenes/scene/pose_log.h"
#include "scenes/scene/scene_file.h"

namespace scb::scenes {
namespace {

namespace fs = std::filesystem;

constexpr const char* what_to_name =
    "a built-in scene, a scene file (.json), one mesh file or two mesh files";

[[noreturn]] void refuse_unknown(const std::string& name) {
    std::vector<std::string> known;
    for (const BuiltinScene& scene : builtin_scenes()) known.push_back(scene.name);
    throw InputError(name + ": there is no such scene or file" + did_you_mean(name, known) +
                     "; name " + what_to_name + " (built in are " + name_list(known) +
                     "; `scb scenes` lists all).");
}

/// The name of a mesh from this file, also for tables and terminals.
std::string stem(const std::string& path) {
    const std::string name = fs::path(path).stem().string();
    return printable(name.empty() ? path : name);
}

bool is_scene_file(const std::string& name) { return fs::path(name).extension() == ".json"; }

/// A word without a folder or an extension is meant as a built-in name.
bool looks_like_path(const std::string& name) {
    return name.find('/') != std::string::npos || !fs::path(name).extension().empty();
}

/// The file for a name on the command line.
fs::path find_mesh(const std::string& name, const fs::path& models_dir) {
    const fs::path path = name;
    // A file that cannot be reached may exist: the code that opens it reports the error.
    const auto may_exist = [](const fs::path& file) {
        std::error_code ignored;
        return fs::status(file, ignored).type() != fs::file_type::not_found;
    };
    if (may_exist(path)) return path;
    const bool look_further = !models_dir.empty() && !name.empty() && path.is_relative();
    if (look_further && may_exist(models_dir / path)) return models_dir / path;
    if (!looks_like_path(name)) refuse_unknown(name);
    throw InputError(name + ": there is no such file" +
                     (look_further ? ", nor is there " + (models_dir / path).string() : "") +
                     "; check the path.");
}

Scene one_mesh(const std::string& name, const fs::path& file) {
    Scene scene;
    scene.name = file_name_of(stem(name));
    scene.meshes.push_back({stem(name), load_mesh(file), file});
    scene.bodies.push_back({stem(name), 0, {}});
    scene.file = file;
    return scene;
}

Scene two_meshes(const std::string& first, const std::string& second, const LoadOptions& options) {
    for (const std::string& name : {first, second})
        if (names_scene(name))
            throw InputError(name +
                             ": this is a scene by itself; name it alone, or name two mesh files.");
    const fs::path first_file = find_mesh(first, options.models_dir),
                   second_file = find_mesh(second, options.models_dir);
    Scene scene = one_mesh(first, first_file);
    std::error_code ignored;
    const bool same_file = fs::equivalent(first_file, second_file, ignored);
    if (!same_file) scene.meshes.push_back({stem(second), load_mesh(second_file), second_file});
    scene.name = file_name_of(stem(first) + "-" + stem(second));
    scene.file.clear();
    const std::array<std::string, 2> bodies = body_names(first, second);
    scene.bodies[0].name = bodies[0];
    scene.bodies.push_back({bodies[1], scene.meshes.size() - 1, {}});
    if (options.pose)
        scene.bodies[1].motion = resting_at(*options.pose, options.exact_poses, "--pose");
    PoseLogs logs(options.exact_poses);
    for (std::size_t side = 0; side < 2; ++side)
        if (!options.logs[side].empty()) scene.bodies[side].motion = logs.read(options.logs[side]);
    scene.frames = std::max(logs.frames(), 1);
    return scene;
}

}  // namespace

std::array<std::string, 2> body_names(const std::string& first, const std::string& second) {
    // Bodies need different names.
    if (stem(first) == stem(second)) return {stem(first) + "-A", stem(second) + "-B"};
    return {stem(first), stem(second)};
}

bool names_scene(const std::string& name) { return find_builtin(name) || is_scene_file(name); }

Scene load_scene(const std::vector<std::string>& names, const LoadOptions& options) {
    if (names.empty() || names.size() > 2)
        throw InputError("SCENE: " + std::to_string(names.size()) + " names are given; name " +
                         what_to_name + ".");
    if (names.size() == 2) return two_meshes(names[0], names[1], options);
    const std::string& name = names[0];
    const bool has_logs = !options.logs[0].empty() || !options.logs[1].empty();
    if (options.pose || has_logs)
        throw InputError((has_logs ? "--poses: it moves" : "--pose: it places the second of") +
                         std::string(" two mesh files, but only ") + name +
                         " is named; name two mesh files or leave it out.");
    if (const BuiltinScene* builtin = find_builtin(name))
        return load_builtin(*builtin, options.models_dir);
    if (is_scene_file(name)) return load_scene_file(name, options.models_dir, options.exact_poses);
    return one_mesh(name, find_mesh(name, options.models_dir));
}

}  // namespace scb::scenes
