#include "core/extremal_points.h"

namespace scb {
namespace {

// Which ids were met, and at which index: open addressing in twice and a half the capacity.
struct MetIds {
    static constexpr std::size_t slots = 64;
    std::array<std::uint8_t, slots> index_plus_1{};
    std::array<std::uint32_t, slots> id;
};

std::uint8_t index_of(std::uint32_t id, MetIds& met, ExtremalPoints& points, const double* x,
                      const double* y, const double* z) {
    std::size_t slot = id % MetIds::slots;
    while (met.index_plus_1[slot] != 0) {
        if (met.id[slot] == id) return static_cast<std::uint8_t>(met.index_plus_1[slot] - 1);
        slot = (slot + 1) % MetIds::slots;
    }
    const std::size_t index = points.count++;
    points.x[index] = x[id];
    points.y[index] = y[id];
    points.z[index] = z[id];
    met.id[slot] = id;
    met.index_plus_1[slot] = static_cast<std::uint8_t>(index + 1);
    return static_cast<std::uint8_t>(index);
}

}  // namespace

ExtremalPoints extremal_points(const Dop26& dop, const double* x, const double* y,
                               const double* z) {
    ExtremalPoints points;
    MetIds met;
    for (std::size_t i = 0; i < Dop26::directions; ++i) {
        points.upper[i] = index_of(dop.upper_id[i], met, points, x, y, z);
        points.lower[i] = index_of(dop.lower_id[i], met, points, x, y, z);
    }
    return points;
}

}  // namespace scb
