#include "app/timing/table_3.h"

#include <array>
#include <iterator>

#include "scenes/scene/scene_group.h"

namespace scb::app {
namespace {

struct Row {
    Table3Entry ball, scb, obb;
};

/// In the order of table_3_scenes.
constexpr std::array<Row, std::size(scenes::table_3_scenes)> rows = {{
    {{8.0, 99733, 10585}, {3.3, 21412, 2112}, {4.9, 13350, 1135}},
    {{16.4, 200235, 20776}, {6.5, 42295, 4419}, {9.2, 24835, 2240}},
    {{9.7, 68543, 15503}, {1.8, 13005, 63}, {3.0, 8731, 0}},
    {{12.5, 121316, 31703}, {1.7, 14189, 53}, {2.4, 9047, 0}},
    {{18.4, 175479, 49840}, {1.8, 14367, 33}, {2.5, 9365, 0}},
    {{8.6, 93193, 12709}, {5.8, 39469, 4773}, {8.4, 23200, 1748}},
    {{101.4, 1028875, 161923}, {62.1, 387257, 53083}, {83.2, 239346, 17522}},
}};

}  // namespace

std::optional<Table3Entry> table_3(std::string_view scene, VolumeKind kind) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (scenes::table_3_scenes[i] != scene) continue;
        if (kind == VolumeKind::ball) return rows[i].ball;
        if (kind == VolumeKind::scb) return rows[i].scb;
        if (kind == VolumeKind::obb) return rows[i].obb;
    }
    return std::nullopt;
}

}  // namespace scb::app
