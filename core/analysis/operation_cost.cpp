#include "core/analysis/cost_equation.h"

#include <initializer_list>

namespace scb {
namespace {

struct StageCost {
    Stage stage;
    std::uint32_t operations;
};

/// `last`: the cost at the last stage, also if none rejects.
std::uint32_t cost_at(Stage stage, std::initializer_list<StageCost> costs, std::uint32_t last) {
    for (const StageCost& cost : costs)
        if (cost.stage == stage) return cost.operations;
    return last;
}

std::uint32_t of_cylinder_tests(Stage stage, std::uint32_t first_cylinder,
                                std::uint32_t second_cylinder) {
    return cost_at(stage,
                   {{Stage::ball_ball, 29},
                    {Stage::slab_ball, 36},
                    {Stage::ball_slab, 60},
                    {Stage::slab_cylinder, first_cylinder}},
                   second_cylinder);
}

std::uint32_t of_extents(Stage stage) {
    return cost_at(stage, {{Stage::ball_ball, 29}, {Stage::slab_a, 69}, {Stage::slab_b, 90}}, 115);
}

/// The worst case: each extent is at a point where two planes meet the sphere, with five square
/// roots each.
std::uint32_t of_two_slabs(Stage stage) {
    return cost_at(stage,
                   {{Stage::ball_ball, 29},
                    {Stage::slab_a, 138},
                    {Stage::second_slab_a, 199},
                    {Stage::slab_b, 265},
                    {Stage::second_slab_b, 311},
                    {Stage::center_line, 391}},
                   479);
}

/// Oriented boxes: 66 for B's center and axes; 27 for each axis of A, with the products of axes
/// that later stages use. Boxes along their body's axes: 21 for B's center, and 7 for each axis of
/// A, which needs no product. Both: 12 for each axis of B, and 11 for each cross product.
std::uint32_t of_boxes(Stage stage, std::uint32_t transformation, std::uint32_t axis_a) {
    constexpr std::uint32_t axis_b = 12, crossed = 11;
    if (stage == Stage::overlapping) return transformation + 3 * axis_a + 3 * axis_b + 9 * crossed;
    const std::uint32_t made =
        static_cast<std::uint32_t>(stage) - static_cast<std::uint32_t>(Stage::axis_a0) + 1;
    if (made <= 3) return transformation + made * axis_a;
    if (made <= 6) return transformation + 3 * axis_a + (made - 3) * axis_b;
    return transformation + 3 * axis_a + 3 * axis_b + (made - 6) * crossed;
}

/// Convex volumes: 24 for B's center. Each direction takes 46 to turn it into B's frame and its
/// farthest point back, and two farthest points. From the second direction on it also takes 80 for
/// the closest point of the simplex. Searches differ in length, and count as four directions: in
/// queries of horse, tr12j and boeing they had 4.5 for k-DOPs, 3.7 for rectangle swept spheres and
/// 2.4 for capsules.
std::uint32_t of_search(Stage stage, std::uint32_t support) {
    const std::uint32_t direction = 46 + 2 * support;
    return stage == Stage::center_line ? 24 + direction : 24 + 4 * direction + 3 * 80;
}

template <Volume V>
std::uint32_t of_search(Stage stage) {
    if constexpr (ConvexVolume<V>) return of_search(stage, V::support_operations);
    return 0;
}

}  // namespace

std::uint32_t operation_cost(VolumeKind kind, const OverlapOptions& options, Stage stage) {
    switch (kind) {
        case VolumeKind::scb:
            break;
        case VolumeKind::ball:
        case VolumeKind::ritter:
            return 29;
        case VolumeKind::obb:
            return of_boxes(stage, 66, 27);
        case VolumeKind::aabb:
            return of_boxes(stage == Stage::overlapping ? Stage::axis_a2 : stage, 21, 7);
        case VolumeKind::aabb_exact:
            return of_boxes(stage, 21, 7);
        case VolumeKind::scb2:
            return of_two_slabs(stage);
        default:
            return with_volume_type(kind, [&]<Volume V>() { return of_search<V>(stage); });
    }
    switch (options.test) {
        case OverlapTest::extents:
            return of_extents(stage);
        case OverlapTest::symmetric:
            return of_cylinder_tests(stage, 87, 98);
        case OverlapTest::printed:
        case OverlapTest::line8:
        case OverlapTest::corrected:
            break;
    }
    return of_cylinder_tests(stage, 76, 84);
}

std::uint64_t operation_count(VolumeKind kind, const OverlapOptions& options,
                              const StageCounts& stages) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < stages.size(); ++i)
        sum += stages[i] * operation_cost(kind, options, static_cast<Stage>(i));
    return sum;
}

}  // namespace scb
