#pragma once

#include <concepts>
#include <cstdint>

#include "scb/overlap_options.h"
#include "scb/volume.h"

namespace scb {

/// N_u of equation 1: the points and directions of B's volumes that these tests transformed. A test
/// of slab cut balls transforms the center, and the normal where it gets that far; of balls the
/// center; of boxes the center and three axes.
template <Volume V>
std::uint64_t transform_count(const StageCounts& stages, const OverlapOptions& options) {
    const std::uint64_t tests = test_count(stages);
    if constexpr (std::same_as<V, Ball>) {
        return tests;
    } else if constexpr (std::same_as<V, Obb>) {
        return 4 * tests;
    } else {
        std::uint64_t without_normal = stages[static_cast<std::size_t>(Stage::ball_ball)];
        if (options.test != OverlapTest::extents)
            without_normal += stages[static_cast<std::size_t>(Stage::slab_ball)];
        return 2 * tests - without_normal;
    }
}

}  // namespace scb
