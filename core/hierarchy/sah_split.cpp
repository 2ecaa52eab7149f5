#include "core/hierarchy/sah_split.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include "core/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/hierarchy/sah_split.cpp"
#include <hwy/foreach_target.h>
// After the line above.
#include "core/hierarchy/box_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

constexpr std::size_t tried_all = 16;
constexpr std::size_t bins = 32;

struct Division {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;
    std::size_t at = 0;  // the number of triangles before the division, or the first bin after it
};

HWY_INLINE double cost(const BoxLanes& box, std::size_t count) {
    return squared_width_sum(box) * static_cast<double>(count);
}

// A shortcut for half of all inner nodes: the same as split_few without the loops. All axes cost
// the same, so it takes the first.
HWY_INLINE std::uint32_t split_two(std::span<std::uint32_t> range, const Primitives& primitives) {
    BoxLanes first = BoxLanes::of(primitives[range[0]]);
    const BoxLanes second = BoxLanes::of(primitives[range[1]]);
    const double sum = cost(first, 1) + cost(second, 1);
    first.add(second);
    if (!(sum < cost(first, 2))) return 0;
    if (ByCentroid{primitives, 0}(range[1], range[0])) std::swap(range[0], range[1]);
    return 1;
}

// Centroids along an axis, and indices of triangles as doubles; unused entries sort last.
struct Keys {
    static_assert(tried_all % BoxLanes::lanes == 0);
    alignas(64) std::array<double, tried_all> key, triangle;

    Keys(std::span<const std::uint32_t> range, const Primitives& primitives, std::size_t axis) {
        key.fill(std::numeric_limits<double>::infinity());
        triangle.fill(0);
        for (std::size_t i = 0; i < range.size(); ++i) {
            key[i] = primitives[range[i]].centroid[axis];
            triangle[i] = range[i];
        }
    }
    // The place of entry i in the order: the number of entries before it.
    HWY_INLINE std::size_t place(std::size_t i, std::size_t count) const {
        const Doubles x = Doubles::all(key[i]), t = Doubles::all(triangle[i]);
        std::size_t before = 0;
        for (std::size_t k = 0; k < count; k += double_lanes) {
            const Doubles y = Doubles::load(&key[k]);
            const auto less = (y < x) | ((y == x) & (Doubles::load(&triangle[k]) < t));
            before += hn::CountTrue(Doubles::D(), less.v);
        }
        return before;
    }
};

HWY_INLINE std::uint32_t split_few(std::span<std::uint32_t> range, const Primitives& primitives) {
    const std::size_t count = range.size(), least = (count + 9) / 10;
    std::array<std::array<std::uint32_t, tried_all>, 3> orders;
    Division best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto& order = orders[axis];
        const Keys keys(range, primitives, axis);
        for (std::size_t i = 0; i < count; ++i) order[keys.place(i, count)] = range[i];
        std::array<double, tried_all> right;
        BoxLanes box = BoxLanes::empty();
        for (std::size_t i = count; i-- > 0;) {
            box.add(BoxLanes::of(primitives[order[i]]));
            right[i] = cost(box, count - i);
        }
        best.cost = std::min(best.cost, right[0]);  // undivided
        box = BoxLanes::empty();
        for (std::size_t i = 1; i < count; ++i) {
            box.add(BoxLanes::of(primitives[order[i - 1]]));
            const double sum = cost(box, i) + right[i];
            if (i >= least && count - i >= least && sum < best.cost)
                best = {sum, static_cast<int>(axis), i};
        }
    }
    if (best.axis < 0) return 0;
    const auto& order = orders[static_cast<std::size_t>(best.axis)];
    std::copy_n(order.begin(), count, range.begin());
    return static_cast<std::uint32_t>(best.at);
}

struct Interval {
    double lower, scale;

    std::size_t bin_of(double x) const {
        return std::min(bins - 1, static_cast<std::size_t>(static_cast<int>((x - lower) * scale)));
    }
};

// The intervals along the three axes between the outermost centroids.
HWY_INLINE std::array<Interval, 3> intervals_of(std::span<const std::uint32_t> range,
                                                const Primitives& primitives) {
    Vec3 lower = Vec3::Constant(1e300), upper = -lower;
    for (const std::uint32_t t : range) {
        const auto& c = primitives[t].centroid;
        const Vec3 centroid(c[0], c[1], c[2]);
        lower = lower.cwiseMin(centroid);
        upper = upper.cwiseMax(centroid);
    }
    std::array<Interval, 3> result;
    for (int axis = 0; axis < 3; ++axis) {
        const double width = upper[axis] - lower[axis];
        result[static_cast<std::size_t>(axis)] = {lower[axis],
                                                  width > 1e-290 ? double{bins} / width : 0};
    }
    return result;
}

struct Bins {
    alignas(64) std::array<BoxLanes::Stored, bins> boxes;
    std::array<std::uint32_t, bins> counts;

    HWY_INLINE void clear() {
        counts.fill(0);
        const BoxLanes none = BoxLanes::empty();
        for (BoxLanes::Stored& box : boxes) none.store(box);
    }
    HWY_INLINE void add(std::size_t bin, const BoxLanes& triangle) {
        BoxLanes box = BoxLanes::load(boxes[bin]);
        box.add(triangle);
        box.store(boxes[bin]);
        ++counts[bin];
    }
};

// Moves the triangles in bins before `at` to the front, in their order; returns their number.
HWY_INLINE std::uint32_t partition(std::span<std::uint32_t> range, const Primitives& primitives,
                                   const Interval& interval, const Division& division) {
    const auto axis = static_cast<std::size_t>(division.axis);
    const auto behind = std::make_unique_for_overwrite<std::uint32_t[]>(range.size());
    std::size_t left = 0, right = 0;
    // The side cannot be predicted, so each triangle is written to both.
    for (const std::uint32_t t : range) {
        const bool before = interval.bin_of(primitives[t].centroid[axis]) < division.at;
        range[left] = t;
        behind[right] = t;
        left += before;
        right += !before;
    }
    std::copy_n(behind.get(), right, range.begin() + static_cast<std::ptrdiff_t>(left));
    return static_cast<std::uint32_t>(left);
}

HWY_INLINE std::uint32_t split_many(std::span<std::uint32_t> range, const Primitives& primitives) {
    const std::size_t count = range.size(), least = (count + 9) / 10;
    const std::array<Interval, 3> intervals = intervals_of(range, primitives);
    std::array<Bins, 3> all;
    for (Bins& of_axis : all) of_axis.clear();
    for (const std::uint32_t t : range) {
        const Primitive& primitive = primitives[t];
        const BoxLanes box = BoxLanes::of(primitive);
        for (std::size_t axis = 0; axis < 3; ++axis)
            all[axis].add(intervals[axis].bin_of(primitive.centroid[axis]), box);
    }
    Division best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<double, bins> right;
        std::size_t behind = 0;
        BoxLanes box = BoxLanes::empty();
        for (std::size_t i = bins; i-- > 0;) {
            box.add(BoxLanes::load(all[axis].boxes[i]));
            behind += all[axis].counts[i];
            right[i] = behind == 0 ? 0 : cost(box, behind);
        }
        best.cost = std::min(best.cost, right[0]);  // undivided
        box = BoxLanes::empty();
        std::size_t before = 0;
        for (std::size_t i = 1; i < bins; ++i) {
            box.add(BoxLanes::load(all[axis].boxes[i - 1]));
            before += all[axis].counts[i - 1];
            if (before < least || count - before < least) continue;
            const double sum = cost(box, before) + right[i];
            if (sum < best.cost) best = {sum, static_cast<int>(axis), i};
        }
    }
    if (best.axis < 0) return 0;
    return partition(range, primitives, intervals[static_cast<std::size_t>(best.axis)], best);
}

std::uint32_t sah_split(std::span<std::uint32_t> range, const Primitives& primitives) {
    if (range.size() == 2) return split_two(range, primitives);
    return range.size() <= tried_all ? split_few(range, primitives) : split_many(range, primitives);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scb {

HWY_EXPORT(sah_split);

SahSplit sah_split_at(SimdLevel level) { return SCB_AT_LEVEL(sah_split, level); }

}  // namespace scb
#endif
