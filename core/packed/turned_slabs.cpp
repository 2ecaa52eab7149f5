#include "core/packed/turned_slabs.h"

#include <cmath>
#include <utility>

namespace scb {
namespace {

Slab turned_around(const Slab& slab) { return {-slab.n, -slab.f, -slab.e}; }

}  // namespace

TurnedSlabs::TurnedSlabs(const Scb2& scb) : slabs(scb.slabs) {
    auto& [first, second] = slabs;
    if (second.e - second.f < first.e - first.f) std::swap(first, second);
    // The first of the four turns, by 0 or by half a circle about an axis, with the largest trace.
    // The four scalar parts are the components of one quaternion.
    const Vec3 line = cross(first.n, second.n);
    const double a = first.n[0], b = second.n[1], c = line[2];
    const std::array<double, 4> traces = {a + b + c, a - b - c, b - a - c, c - a - b};
    std::size_t best = 0;
    for (std::size_t i = 1; i < traces.size(); ++i)
        if (traces[i] > traces[best]) best = i;
    if (best >= 2) first = turned_around(first);
    if (best % 2 == 1) second = turned_around(second);
    const Vec3 axis = cross(first.n, second.n);
    const double w = std::sqrt(1 + traces[best]) / 2;
    q = Vec3(second.n[2] - axis[1], axis[0] - first.n[2], first.n[1] - second.n[0]) / (4 * w);
}

}  // namespace scb
