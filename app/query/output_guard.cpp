#include "app/query/output_guard.h"

#include <filesystem>

#include "render/files/output_file.h"
#include "scb/error.h"

namespace scb::app {
namespace {

void refuse_same_file(const std::string& output, const std::string& option,
                      const std::filesystem::path& input) {
    std::error_code ignored;
    if (std::filesystem::equivalent(output, input, ignored))
        throw InputError(option + " " + output +
                         ": the scene is read from this file; name another.");
}

}  // namespace

void refuse_overwriting(const std::string& path, const std::string& option,
                        const SceneOptions& scene) {
    for (const std::string& name : scene.names)
        for (const std::filesystem::path& folder :
             {std::filesystem::path(), std::filesystem::path(scene.models_dir)})
            refuse_same_file(path, option, folder / name);
}

void check_output(const std::string& path, const std::string& option, const scenes::Scene& scene) {
    for (const scenes::NamedMesh& mesh : scene.meshes) refuse_same_file(path, option, mesh.file);
}

void refuse_inputs(const std::string& path, const std::string& option, const SceneOptions& options,
                   const scenes::Scene& scene) {
    refuse_overwriting(path, option, options);
    check_output(path, option, scene);
}

void check_output(const std::string& path, const std::string& option, const SceneOptions& scene,
                  const std::string& folder_to_make) {
    if (path == "-") throw InputError(option + " -: standard output is taken; name a file.");
    std::error_code ignored;
    refuse_overwriting(path, option, scene);
    // Before the work, not after it.
    std::filesystem::path parent = std::filesystem::path(path).parent_path();
    if (parent.empty()) parent = ".";
    const auto folder_of = [](const std::filesystem::path& file) {
        std::error_code none;
        return std::filesystem::weakly_canonical(file, none).parent_path();
    };
    const bool will_be_made =
        !folder_to_make.empty() &&
        folder_of(std::filesystem::path(folder_to_make) / "file") == folder_of(parent / "file");
    if (!will_be_made && !std::filesystem::is_directory(parent, ignored))
        throw render::OutputError(option + " " + path + ": there is no folder " + parent.string() +
                                  "; create it first.");
    if (std::filesystem::is_directory(path, ignored) || path.back() == '/')
        throw render::OutputError(option + " " + path + ": a folder has that name; name a file.");
}

}  // namespace scb::app
