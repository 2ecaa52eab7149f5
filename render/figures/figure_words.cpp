#include "render/figures/figure_words.h"

#include <algorithm>
#include <string_view>

#include "scb/any_hierarchy.h"

namespace scb::render {

std::vector<std::string> column_names(std::vector<PanelItem>& items,
                                      const std::vector<std::string>& names, bool has_letters) {
    // So many characters fit beside another body's name.
    constexpr std::size_t most = 7;
    constexpr std::string_view letters = "AB";
    const bool are_short = std::all_of(names.begin(), names.end(),
                                       [](const std::string& name) { return name.size() <= most; });
    const bool are_letters = names == std::vector<std::string>{"A", "B"};
    if (names.size() > letters.size() || are_letters || (are_short && !has_letters)) return names;
    std::vector<std::string> columns;
    std::string note;
    for (std::size_t b = 0; b < names.size(); ++b) {
        columns.emplace_back(1, letters[b]);
        note += (b == 0 ? "" : ", ") + columns.back() + " " + names[b];
    }
    items.emplace_back(PanelNote{note});
    return columns;
}

ItemCount item_count(const Mesh& mesh, const Tree& tree) {
    if (!mesh.triangles.empty()) return {"triangles", mesh.triangles.size()};
    std::size_t objects = 0;
    for (std::uint32_t node = 0; node < tree.size(); ++node) objects += tree.items(node).size();
    return {"objects", objects};
}

std::string_view item_words(const std::vector<ItemCount>& counts) {
    const bool alike = std::all_of(counts.begin(), counts.end(), [&](const ItemCount& count) {
        return count.what == counts.front().what;
    });
    return alike ? counts.front().what : "items";
}

std::string_view volume_title(VolumeKind kind) {
    switch (kind) {
        case VolumeKind::scb:
            break;
        case VolumeKind::ball:
            return "ball";
        case VolumeKind::ritter:
            return "ball (Ritter)";
        case VolumeKind::obb:
            return "OBB";
        case VolumeKind::scb2:
            return "SCB2";
        case VolumeKind::aabb:
            return "AABB";
        case VolumeKind::aabb_exact:
            return "AABB (exact)";
        default:
            return with_volume_type(kind, []<Volume V>() -> std::string_view {
                if constexpr (ConvexVolume<V>) return V::title;
                return "";
            });
    }
    return "SCB";
}

std::string volume_title(const TraceHeader& header) {
    if (!header.engine) return std::string(volume_title(header.volume));
    const std::string& volumes = header.engine->volumes;
    return header.engine->name + (volumes.empty() ? "" : ", " + volumes);
}

}  // namespace scb::render
