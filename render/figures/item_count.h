#pragma once

#include <string_view>
#include <vector>

#include "core/model/tree.h"
#include "scb/mesh.h"

namespace scb::render {

/// What the nodes of a body hold, and how many: its triangles or, where it has none, objects.
struct ItemCount {
    std::string_view what;
    std::size_t count = 0;
};
ItemCount item_count(const Mesh& mesh, const Tree& tree);

/// "triangles", "objects", or of both "items".
std::string_view item_words(const std::vector<ItemCount>& counts);

}  // namespace scb::render
