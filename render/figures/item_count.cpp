#include "render/figures/item_count.h"

#include <algorithm>

namespace scb::render {

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

}  // namespace scb::render
