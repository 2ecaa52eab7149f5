#include "core/fit/extremal_points.h"

namespace scb {
namespace {

// The ids met so far, and their indices: a hash table with open addressing and two and a half times
// the capacity.
struct MetIds {
    static constexpr std::size_t slots = 64;
    std::array<std::uint8_t, slots> index_plus_1{};
    std::array<std::size_t, slots> id;
};

std::int32_t index_of(std::size_t id, MetIds& met, const PointsView& by_id, FewPoints& points) {
    std::size_t slot = id % MetIds::slots;
    while (met.index_plus_1[slot] != 0) {
        if (met.id[slot] == id) return met.index_plus_1[slot] - 1;
        slot = (slot + 1) % MetIds::slots;
    }
    const std::size_t index = points.count;
    points.add(by_id.x[id], by_id.y[id], by_id.z[id]);
    met.id[slot] = id;
    met.index_plus_1[slot] = static_cast<std::uint8_t>(index + 1);
    return static_cast<std::int32_t>(index);
}

}  // namespace

void extremal_points(const Dop26& dop, const PointsView& by_id, FewPoints& points,
                     ExtremalPairs& pairs) {
    points.count = 0;
    MetIds met;
    for (std::size_t i = 0; i < Dop26::directions; ++i) {
        pairs.upper[i] = index_of(static_cast<std::size_t>(dop.upper_id[i]), met, by_id, points);
        pairs.lower[i] = index_of(static_cast<std::size_t>(dop.lower_id[i]), met, by_id, points);
    }
    points.pad();
}

}  // namespace scb
