#include "app/query/scene_title.h"

#include "scenes/text/utf8.h"

namespace scb::app {

std::string scene_title(const std::string& scene, const std::string& a, const std::string& b) {
    const std::string mesh = a.substr(0, a.rfind("-A"));
    const bool twice = mesh + "-A" == a && mesh + "-B" == b && scene == mesh + "-" + mesh;
    return scenes::printable(twice ? mesh + " with itself" : scene);
}

}  // namespace scb::app
