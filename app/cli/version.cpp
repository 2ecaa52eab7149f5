#include "app/cli/version.h"

#include <Eigen/Core>
#include <optional>

#include <imgui.h>

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

std::string compiler_text() { return SCB_COMPILER; }

std::string version_text() {
    std::string text;
    const auto add = [&text](const render::GlInfo* gl) {
        for (const auto& [name, version] : versions(gl))
            text += name + std::string(name.size() < 6 ? 6 - name.size() : 0, ' ') + " " + version +
                    "\n";
    };
    for (const render::GlBackend backend : {render::GlBackend::osmesa, render::GlBackend::egl}) {
        try {
            const render::Context context(backend);
            add(&context.info());
            return text;
        } catch (const render::GlError&) {
            // The other back end may still have it.
        }
    }
    add(nullptr);
    return text + "gl     none\n";
}

}  // namespace scb::app
