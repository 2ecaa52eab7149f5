#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/hierarchy/tree_shape.h"
#include "core/volumes/measured_shape.h"

namespace scb {

/// Calls `reached(node, depth)` for each node if `meets` is true of the node and of all nodes above
/// it: the nodes that a query would reach. `stack` is scratch space.
template <class Meets, class Reached>
void descend(const TreeShape& shape, Meets&& meets, Reached&& reached,
             std::vector<std::pair<std::uint32_t, std::uint32_t>>& stack) {
    stack.clear();
    for (const std::uint32_t root : shape.roots) stack.emplace_back(root, 0);
    while (!stack.empty()) {
        const auto [node, depth] = stack.back();
        stack.pop_back();
        if (!meets(node)) continue;
        reached(node, depth);
        for (std::uint32_t child = shape.first_child[node]; child != no_index;
             child = shape.next_sibling[child])
            stack.emplace_back(child, depth + 1);
    }
}

/// Points of the unit cube, evenly spread: Halton's sequence in the bases 2, 3 and 5 ("On the
/// Efficiency of Certain Quasi-Random Sequences of Points", 1960).
inline std::vector<Vec3> halton_points(std::size_t count) {
    const auto reversed = [](std::size_t i, std::size_t base) {
        double result = 0, digit = 1;
        for (; i > 0; i /= base) {
            digit /= static_cast<double>(base);
            result += digit * static_cast<double>(i % base);
        }
        return result;
    };
    std::vector<Vec3> points(count);
    for (std::size_t i = 0; i < count; ++i)
        points[i] = {reversed(i + 1, 2), reversed(i + 1, 3), reversed(i + 1, 5)};
    return points;
}

/// How many points are inside of one volume, and of these inside of another, too.
struct SharedPoints {
    std::uint32_t inside = 0, shared = 0;

    double share() const { return inside == 0 ? 0 : static_cast<double>(shared) / inside; }
    /// The variance for independent points; evenly spread points do better. A share of 0 or 1 is
    /// not certain, and counts as half a point.
    double variance() const {
        if (inside == 0) return 0;
        const double n = inside, p = std::clamp(share(), 0.5 / n, 1 - 0.5 / n);
        return p * (1 - p) / n;
    }
};

/// Counts points in a box about `smaller`. `points` are of the unit cube, shifted at random by
/// `seed` (Cranley and Patterson, "Randomization of Number Theoretic Methods for Multiple
/// Integration", 1976).
template <Volume V>
SharedPoints shared_points(const V& smaller, const V& larger, std::span<const Vec3> points,
                           std::uint64_t seed) {
    SharedPoints result;
    Random random(seed);
    Vec3 shift;
    // The order of draws in a list of arguments would depend on the compiler.
    for (int i = 2; i >= 0; --i) shift[i] = random.uniform();
    const Obb box = box_about(smaller);
    for (const Vec3& point : points) {
        Vec3 p = box.center;
        for (int i = 0; i < 3; ++i) {
            const double u = point[i] + shift[i];
            p += box.axes.col(i) * (box.half[i] * (2 * (u < 1 ? u : u - 1) - 1));
        }
        if (!contains(smaller, p)) continue;
        ++result.inside;
        if (contains(larger, p)) ++result.shared;
    }
    return result;
}

}  // namespace scb
