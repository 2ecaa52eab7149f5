#include "app/study/layout_time.h"

#include <array>
#include <bit>
#include <cassert>

namespace scb::app {

std::uint64_t layout_time(VolumeKind volume, const PackedLayout& layout, std::uint64_t n_v,
                          std::uint64_t n_p, std::uint64_t pairs) {
    // Of a test of two volumes: floats, quantized, indexed; nodes of 2, 4 and 8 children.
    using Times = std::array<std::array<std::uint64_t, 3>, 3>;
    constexpr Times one_slab = {
        {{11'800, 5'600, 2'450}, {12'000, 5'700, 2'600}, {13'100, 6'350, 2'980}}};
    constexpr Times two_slabs = {
        {{22'800, 10'500, 5'150}, {23'600, 11'100, 5'290}, {24'300, 11'600, 5'770}}};
    assert((volume == VolumeKind::scb || volume == VolumeKind::scb2) && "see can_pack");
    const bool indexed = layout.corners == LeafCorners::in_mesh;
    const std::size_t numbers = indexed                                              ? 2
                                : layout.numbers == PackedLayout::Numbers::quantized ? 1
                                                                                     : 0,
                      width = std::bit_width(static_cast<unsigned>(layout.width)) - 2u;
    const Times& times = volume == VolumeKind::scb ? one_slab : two_slabs;
    constexpr std::uint64_t pair = 40'000;
    return times[numbers][width] * n_v + (indexed ? 11'400 : 7'900) * n_p + pair * pairs;
}

}  // namespace scb::app
