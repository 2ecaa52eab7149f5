#include "app/cli/version.h"

#include <imgui.h>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "core/base/text_format.h"

namespace scb::app {

std::vector<std::pair<std::string, std::string>> versions(const render::GlInfo* gl) {
    std::vector<std::pair<std::string, std::string>> list = {{"scb", SCB_VERSION}};
    if (gl != nullptr) {
        list.emplace_back("gl", gl->backend + ", OpenGL " + gl->version + ", " + gl->renderer);
        list.emplace_back("mesa", gl->mesa);
        list.emplace_back("llvm", gl->llvm);
    }
    list.emplace_back("eigen", std::to_string(EIGEN_WORLD_VERSION) + "." +
                                   std::to_string(EIGEN_MAJOR_VERSION) + "." +
                                   std::to_string(EIGEN_MINOR_VERSION));
    list.emplace_back("imgui", IMGUI_VERSION);
    return list;
}

nlohmann::ordered_json versions_json(const render::GlInfo* gl) {
    nlohmann::ordered_json json;
    for (const auto& [name, version] : versions(gl)) json[name] = version;
    return json;
}

std::string compiler_text() { return SCB_COMPILER; }

namespace {

/// Uses the first back end that works.
std::vector<std::pair<std::string, std::string>> present_versions() {
    for (const render::GlBackend backend : {render::GlBackend::osmesa, render::GlBackend::egl}) {
        try {
            return versions(&render::Context(backend).info());
        } catch (const render::GlError&) {
            // The other back end may still work.
        }
    }
    auto list = versions(nullptr);
    list.emplace_back("gl", "none");
    return list;
}

}  // namespace

std::string version_text() {
    std::string text;
    for (const auto& [name, version] : present_versions())
        text += left_aligned(name, 6) + " " + version + "\n";
    return text;
}

std::string version_json() {
    nlohmann::ordered_json json;
    for (const auto& [name, version] : present_versions()) json[name] = version;
    return json.dump(2) + "\n";
}

}  // namespace scb::app
