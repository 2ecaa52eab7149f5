#include "scb/packed_layout.h"

#include <array>

namespace scb {
namespace {

using Numbers = PackedLayout::Numbers;

constexpr std::array layouts = {
    PackedLayout{Numbers::floats, 2},
    PackedLayout{Numbers::floats, 4},
    PackedLayout{Numbers::floats, 8},
    PackedLayout{Numbers::quantized, 2},
    PackedLayout{Numbers::quantized, 4},
    PackedLayout{Numbers::quantized, 8},
    PackedLayout{Numbers::quantized, 2, 4, LeafCorners::in_mesh},
    PackedLayout{Numbers::quantized, 4, 4, LeafCorners::in_mesh},
    PackedLayout{Numbers::quantized, 8, 4, LeafCorners::in_mesh},
};

}  // namespace

std::string packed_layout_name(const PackedLayout& layout) {
    const char* kind = layout.corners == LeafCorners::in_mesh ? "indexed"
                       : layout.numbers == Numbers::floats    ? "float"
                                                              : "quantized";
    return std::string(kind) + std::to_string(layout.width);
}

std::optional<PackedLayout> packed_layout_of(std::string_view name) {
    for (const PackedLayout& layout : layouts)
        if (packed_layout_name(layout) == name) return layout;
    return std::nullopt;
}

std::span<const PackedLayout> all_packed_layouts() { return layouts; }

}  // namespace scb
