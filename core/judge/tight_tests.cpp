#include "core/judge/tight_tests.h"
#include "scb/triangle_overlap.h"

#include <algorithm>
#include <cmath>

namespace scb {
namespace {

/// Intervals along the axes of a box, relative to its center.
struct Extents {
    Vec3 lower = Vec3::Constant(HUGE_VAL), upper = Vec3::Constant(-HUGE_VAL);

    void add(const Obb& box, const Vec3& p) {
        for (int i = 0; i < 3; ++i) {
            const double along = dot(Vec3(box.axes.col(i)), Vec3(p - box.center));
            lower[i] = std::min(lower[i], along);
            upper[i] = std::max(upper[i], along);
        }
    }
    void add(const Obb& box, const ConvexShape& shape) {
        for (int i = 0; i < 3; ++i) {
            const Vec3 axis = box.axes.col(i);
            const double at = dot(axis, Vec3(shape.center - box.center));
            lower[i] = std::min(lower[i], at - support(shape, Vec3(-axis)));
            upper[i] = std::max(upper[i], at + support(shape, axis));
        }
    }
};

const Obb* box_of(const NodeVolume& volume) { return std::get_if<Obb>(&volume); }

/// Oriented boxes stay unchanged if they would take more steps than this.
constexpr std::uint64_t most_steps = 20'000'000;

bool is_along_axes(const Obb& box) { return box.axes == Mat3::Identity(); }

/// Calls `add` with the points or the extent of each item of the node.
template <class Add>
void for_each_item(const EngineSide& side, std::uint32_t node, Add&& add) {
    for (const std::uint32_t item : side.tree->items(node)) {
        if (side.mesh) {
            if (item < side.mesh->triangles.size() && has_finite_corners(*side.mesh, item))
                for (const Vec3& corner : corners(*side.mesh, item)) add(corner);
        } else if (const NodeVolume* object = side.tree->object_volume(item)) {
            add(convex_shape(*object));
        }
    }
}

/// Per node, the extents of the items below it along the axes of its box.
std::vector<Extents> extents_below(const EngineSide& side) {
    const EngineNodes& tree = *side.tree;
    const TreeShape& shape = *side.shape;
    const Obb along{};  // the body's axes
    std::vector<Extents> of_axes(tree.size()), extents(tree.size());
    std::uint64_t steps = 0;
    for (auto node = shape.order.rbegin(); node != shape.order.rend(); ++node) {
        for_each_item(side, *node, [&](const auto& of) { of_axes[*node].add(along, of); });
        steps += shape.depths[*node] * std::uint64_t{tree.items(*node).size()};
        if (const std::uint32_t parent = shape.parents[*node]; parent != no_index) {
            of_axes[parent].lower = of_axes[parent].lower.cwiseMin(of_axes[*node].lower);
            of_axes[parent].upper = of_axes[parent].upper.cwiseMax(of_axes[*node].upper);
        }
    }
    for (std::uint32_t node = 0; node < tree.size(); ++node)
        if (const Obb* box = box_of(tree[node].volume); box && is_along_axes(*box)) {
            extents[node].lower = of_axes[node].lower - box->center;
            extents[node].upper = of_axes[node].upper - box->center;
        }
    if (steps > most_steps) return extents;
    for (const std::uint32_t holder : shape.order)
        for_each_item(side, holder, [&](const auto& of) {
            for (std::uint32_t node = holder; node != no_index; node = shape.parents[node])
                if (const Obb* box = box_of(tree[node].volume); box && !is_along_axes(*box))
                    extents[node].add(*box, of);
        });
    return extents;
}

}  // namespace

TightBoxes tight_boxes(const EngineSide& side) {
    const EngineNodes& tree = *side.tree;
    const std::vector<Extents> extents = extents_below(side);
    TightBoxes result;
    for (std::uint32_t node = 0; node < tree.size(); ++node) {
        result.volumes.push_back(tree[node].volume);
        const Obb* box = box_of(tree[node].volume);
        const Extents& of = extents[node];
        if (!box || !(of.lower[0] <= of.upper[0])) continue;
        Obb tight = *box;
        // Items outside of the box stay outside.
        const Vec3 lower = of.lower.cwiseMax(-box->half).cwiseMin(box->half),
                   upper = of.upper.cwiseMin(box->half).cwiseMax(lower);
        for (int i = 0; i < 3; ++i)
            tight.center += box->axes.col(i) * (lower[i] + (upper[i] - lower[i]) / 2);
        tight.half = (upper - lower) / 2;
        ++result.boxes;
        const double longest = tight.half.maxCoeff();
        result.loose += (box->half - tight.half).maxCoeff() > longest / 2;
        result.volumes.back() = tight;
    }
    return result;
}

std::uint64_t tests_with(const EngineQuery& query, std::span<const JudgedTest> tests,
                         const TightBoxes& of_a, const TightBoxes& of_b) {
    // Whether the query would go on below a test.
    std::vector<bool> passes(tests.size(), false);
    std::uint64_t made = 0;
    for (std::size_t i = 0; i < tests.size(); ++i) {
        const JudgedTest& test = tests[i];
        if (test.parent != no_index && !passes[test.parent]) continue;
        ++made;
        if (query.events[test.event].stage != 0) continue;
        passes[i] = test.nodes.a == no_index || test.nodes.b == no_index ||
                    exact_verdict(of_a.volumes[test.nodes.a], of_b.volumes[test.nodes.b],
                                  query.b_to_a, tolerance_of(query, test.nodes))
                            .contact != Contact::disjoint;
    }
    return made;
}

}  // namespace scb
