#pragma once

#include <string_view>
#include <vector>

namespace scb {

/// The vector instructions that kernels may use. Results have the same bits at every level.
enum class SimdLevel {
    best,    ///< the best that was compiled and that this CPU has
    base,    ///< every CPU has it: one number at a time on x86-64, NEON on aarch64
    sse4,    ///< SSE4.1 and its likes
    avx2,    ///< AVX2, 8 floats
    avx512,  ///< AVX-512, 16 floats
};

/// The levels that this CPU has, `best` first.
std::vector<SimdLevel> available_simd_levels();

/// "best", "base", "sse4", "avx2", "avx512".
std::string_view simd_level_name(SimdLevel level);

}  // namespace scb
