#include "core/hierarchy/sah_split.h"

#include <algorithm>
#include <array>
#include <limits>

namespace scb {
namespace {

constexpr int bins = 32;
constexpr std::size_t tried_all = 16;

double cost(const Box& box, std::size_t count) {
    const Vec3 sides = box.upper - box.lower;
    const double sum = sides[0] + sides[1] + sides[2];
    return sum * sum * static_cast<double>(count);
}

struct Division {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;
    std::size_t at = 0;  // of how many triangles, or before which bin
};

std::uint32_t split_few(std::span<std::uint32_t> range, const Primitives& primitives) {
    const std::size_t count = range.size(), least = (count + 9) / 10;
    std::array<std::array<std::uint32_t, tried_all>, 3> orders;
    Division best;
    for (int axis = 0; axis < 3; ++axis) {
        auto& order = orders[static_cast<std::size_t>(axis)];
        std::copy(range.begin(), range.end(), order.begin());
        std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                  ByCentroid{primitives, axis});
        std::array<double, tried_all> right{};
        Box box;
        for (std::size_t i = count; i-- > 0;) {
            box.add(primitives.boxes[order[i]]);
            right[i] = cost(box, count - i);
        }
        best.cost = std::min(best.cost, right[0]);  // undivided
        box = {};
        for (std::size_t i = 1; i < count; ++i) {
            box.add(primitives.boxes[order[i - 1]]);
            const double sum = cost(box, i) + right[i];
            if (i >= least && count - i >= least && sum < best.cost) best = {sum, axis, i};
        }
    }
    if (best.axis < 0) return 0;
    const auto& order = orders[static_cast<std::size_t>(best.axis)];
    std::copy_n(order.begin(), count, range.begin());
    return static_cast<std::uint32_t>(best.at);
}

struct Bins {
    double lower, scale;

    int of(double x) const { return std::min(bins - 1, static_cast<int>((x - lower) * scale)); }
};

std::uint32_t split_many(std::span<std::uint32_t> range, const Primitives& primitives) {
    const std::size_t count = range.size(), least = (count + 9) / 10;
    Box centroids;
    for (const std::uint32_t t : range) centroids.add(primitives.centroids[t]);
    std::array<Bins, 3> of_axis;
    struct Bin {
        Box box;
        std::size_t count = 0;
    };
    std::array<std::array<Bin, bins>, 3> all{};
    for (int axis = 0; axis < 3; ++axis) {
        const double width = centroids.upper[axis] - centroids.lower[axis];
        of_axis[static_cast<std::size_t>(axis)] = {centroids.lower[axis],
                                                   width > 1e-290 ? bins / width : 0};
    }
    for (const std::uint32_t t : range)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Bin& bin = all[axis][static_cast<std::size_t>(
                of_axis[axis].of(primitives.centroids[t][static_cast<int>(axis)]))];
            bin.box.add(primitives.boxes[t]);
            ++bin.count;
        }
    Division best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<double, bins> right;
        std::size_t behind = 0;
        Box box;
        for (std::size_t i = bins; i-- > 0;) {
            box.add(all[axis][i].box);
            behind += all[axis][i].count;
            right[i] = behind == 0 ? 0 : cost(box, behind);
        }
        best.cost = std::min(best.cost, right[0]);  // undivided
        box = {};
        std::size_t before = 0;
        for (std::size_t i = 1; i < bins; ++i) {
            box.add(all[axis][i - 1].box);
            before += all[axis][i - 1].count;
            if (before < least || count - before < least) continue;
            const double sum = cost(box, before) + right[i];
            if (sum < best.cost) best = {sum, static_cast<int>(axis), i};
        }
    }
    if (best.axis < 0) return 0;
    const Bins& chosen = of_axis[static_cast<std::size_t>(best.axis)];
    const auto middle = std::stable_partition(range.begin(), range.end(), [&](std::uint32_t t) {
        return chosen.of(primitives.centroids[t][best.axis]) < static_cast<int>(best.at);
    });
    return static_cast<std::uint32_t>(middle - range.begin());
}

}  // namespace

std::uint32_t sah_split(std::span<std::uint32_t> range, const Primitives& primitives) {
    return range.size() <= tried_all ? split_few(range, primitives) : split_many(range, primitives);
}

}  // namespace scb
