#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace scb {

/// How a test of two volumes A and B ended: with `overlapping`, or at the stage that rejected the
/// pair. All tests share one list, so that counts, traces and colors agree. The values behind the
/// tests' stages name what followed if the volumes overlap. An engine's stages come last, see
/// StageTable.
enum class Stage : std::uint8_t {
    overlapping,  ///< not rejected

    // Slab cut balls: the rows of Table 1. Balls have the first one only.
    ball_ball,      ///< ball A, ball B
    slab_ball,      ///< slab A, ball B
    ball_slab,      ///< ball A, slab B
    slab_cylinder,  ///< slab A, cylinder about B
    cylinder_slab,  ///< cylinder about A, slab B

    // Slab cut balls by their exact extents; ball_ball comes before.
    slab_a,       ///< along the normal of A
    slab_b,       ///< along the normal of B
    center_line,  ///< along the line through the centers

    // Oriented boxes: the separating axes, in the order in which they are tried.
    axis_a0,     ///< A's first axis
    axis_a1,     ///< A's second axis
    axis_a2,     ///< A's third axis
    axis_b0,     ///< B's first axis
    axis_b1,     ///< B's second axis
    axis_b2,     ///< B's third axis
    axis_a0_b0,  ///< the product of A's first and B's first axis
    axis_a0_b1,  ///< the product of A's first and B's second axis
    axis_a0_b2,  ///< the product of A's first and B's third axis
    axis_a1_b0,  ///< the product of A's second and B's first axis
    axis_a1_b1,  ///< the product of A's second and B's second axis
    axis_a1_b2,  ///< the product of A's second and B's third axis
    axis_a2_b0,  ///< the product of A's third and B's first axis
    axis_a2_b1,  ///< the product of A's third and B's second axis
    axis_a2_b2,  ///< the product of A's third and B's third axis

    // Balls cut by two slabs: ball_ball, slab_a, second_slab_a, slab_b, second_slab_b, center_line,
    // long_axes.
    second_slab_a,  ///< along the normal of A's second slab
    second_slab_b,  ///< along the normal of B's second slab
    long_axes,      ///< along the product of the long axes

    // Convex volumes by their farthest points; center_line comes before.
    search,  ///< along a direction that the search for the closest points reached

    // What followed a test of two volumes that overlap. The path of the traversal ended:
    triangles_apart,  ///< at two leaves, whose triangles do not intersect
    triangles_meet,   ///< at two leaves, whose triangles intersect
    found,            ///< at nodes of the level at which the query stopped
    neighbors,        ///< at two leaves of a self query, whose triangles share a vertex
    left_over,        ///< because the query had enough pairs before it divided these nodes
    // Or it went on, with the tests of children:
    divided_a,     ///< of A's node
    divided_b,     ///< of B's node
    divided_both,  ///< of both nodes, as some engines do
};
/// The number of results of a test: `overlapping`, and the stages that reject.
inline constexpr std::size_t stage_count = 28;
/// The number of rows that this project names.
inline constexpr std::size_t named_stage_count = stage_count + 8;

/// Tests per stage, indexed by Stage; an engine's own stages are not counted here.
using StageCounts = std::array<std::uint64_t, stage_count>;

/// The sum of all counts: N_v of equation 1.
std::uint64_t test_count(const StageCounts& counts);

/// "overlapping", "ball-ball", "slab-cylinder", "axis-a0xb2", "triangles meet", ... `stage` must be
/// below named_stage_count.
std::string_view stage_name(Stage stage);
/// The stage of this name, if any.
std::optional<Stage> stage_of(std::string_view name);

}  // namespace scb
