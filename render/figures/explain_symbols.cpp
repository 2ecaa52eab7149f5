#include "render/figures/explain_symbols.h"

namespace scb::render {

std::vector<std::string_view> symbol_lines(VolumeKind kind, const OverlapOptions& options) {
    switch (kind) {
        case VolumeKind::ball:
        case VolumeKind::ritter:
            return {};
        case VolumeKind::obb:
        case VolumeKind::aabb:
        case VolumeKind::aabb_exact:
            return {"a, b: the axes of the boxes; ρ: how far a box reaches along the axis."};
        case VolumeKind::scb2:
            return {
                "0: of A; 1: of B; ″: of the second slab; d: of the other center, along the normal "
                "n;",
                "ρ: how far a volume reaches in a direction; u: from A's center to B's; w: the "
                "product "
                "of the long axes; sλ: the sine of their angle."};
        case VolumeKind::scb:
            break;
        default:
            return {
                "ρ: how far a volume reaches in a direction; u: from A's center to B's; w: a "
                "direction that the search for the closest points tried."};
    }
    switch (options.test) {
        case OverlapTest::symmetric:
            return {
                "m, h: middle of a slab and half its thickness, so e = m + h, f = m − h; r·sα: "
                "effective radius of the cylinder about the slab cut ball; sα is rounded up."};
        case OverlapTest::extents:
            return {
                "ρ: how far a slab cut ball reaches in that direction; u: the direction from A's "
                "center to B's."};
        default:
            return {
                "r·sα: effective radius of the cylinder about the slab cut ball; sα is rounded "
                "up."};
    }
}

}  // namespace scb::render
