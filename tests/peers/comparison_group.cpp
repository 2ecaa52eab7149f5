#include "tests/peers/comparison_group.h"

#include <algorithm>

#include "scenes/scene/scene_group.h"

namespace scb {

void add_to_group(std::vector<ComparisonGroup>& groups, SceneComparison scene) {
    const auto is_in = [&](std::string_view name) {
        return scenes::has_scene(*scenes::find_scene_group(name), scene.scene);
    };
    const std::string title = is_in("cad")           ? "CAD models"
                              : is_in("cad-aligned") ? "Parts that lie on each other"
                                                     : "";
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const ComparisonGroup& other) { return other.title == title; });
    if (group == groups.end()) group = groups.insert(group, {title, {}});
    group->scenes.push_back(std::move(scene));
}

bool finds_the_same(std::span<const ComparisonGroup> groups, std::size_t peer) {
    return std::all_of(groups.begin(), groups.end(), [peer](const ComparisonGroup& group) {
        return std::all_of(
            group.scenes.begin(), group.scenes.end(),
            [peer](const SceneComparison& scene) { return scene.peers[peer].difference.none(); });
    });
}

}  // namespace scb
