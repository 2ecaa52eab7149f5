#pragma once

#include <string_view>
#include <vector>

#include "core/model/tree.h"
#include "scb/mesh.h"

namespace scb::render {

/// The kind and number of a body's items: its triangles or, if it has none, objects.
struct ItemCount {
    std::string_view what;
    std::size_t count = 0;
};
ItemCount item_count(const Mesh& mesh, const Tree& tree);

/// "triangles", "objects", or "items" for both.
std::string_view item_words(const std::vector<ItemCount>& counts);

}  // namespace scb::render
