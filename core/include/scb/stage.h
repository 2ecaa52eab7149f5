#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace scb {

/// How an overlap test of two volumes A and B ended: with `overlapping`, or at the stage that
/// rejected the pair. One list for all tests, so that counts, traces and colors mean the same for
/// each of them.
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
    search,  ///< along a direction that the search for the closest points came to
};
/// How many stages there are, `overlapping` included.
inline constexpr std::size_t stage_count = 28;

/// A stage of a test that is none of this project's, by the number of who made it, 1 to 127. It has
/// no name here, and is above all others.
constexpr Stage foreign_stage(std::uint8_t number) { return static_cast<Stage>(64 + number); }
/// Whether it is one of `foreign_stage`.
constexpr bool is_foreign(Stage stage) { return static_cast<std::uint8_t>(stage) > 64; }
/// Its number there, where it is foreign.
constexpr std::uint8_t foreign_number(Stage stage) {
    return static_cast<std::uint8_t>(static_cast<std::uint8_t>(stage) - 64);
}

/// Tests per stage, indexed by Stage; foreign ones have no place.
using StageCounts = std::array<std::uint64_t, stage_count>;

/// The sum of all counts: N_v of equation 1.
std::uint64_t test_count(const StageCounts& counts);

/// "overlapping", "ball-ball", "slab-cylinder", "axis-a0", "axis-a0xb2", ...
std::string_view stage_name(Stage stage);
/// The stage of this name, or nothing where there is none.
std::optional<Stage> stage_of(std::string_view name);

}  // namespace scb
