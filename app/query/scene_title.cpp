#include "app/query/scene_title.h"

#include "core/platform/utf8.h"

namespace scb::app {

std::string bodies_text(const TraceHeader& header) {
    const auto [a, b] = body_names(header);
    return printable(header.kind == QueryKind::self ? a + " against itself" : a + " and " + b);
}

std::string scene_title(const std::string& scene, const std::string& a, const std::string& b) {
    const std::string mesh = a.substr(0, a.rfind("-A"));
    const bool twice = mesh + "-A" == a && mesh + "-B" == b && scene == mesh + "-" + mesh;
    return printable(twice ? mesh + " with itself" : scene);
}

std::string scene_title(const TraceHeader& header) {
    const auto [a, b] = body_names(header);
    return scene_title(header.scene, a, b) +
           (header.kind == QueryKind::self ? " against itself" : "");
}

}  // namespace scb::app
