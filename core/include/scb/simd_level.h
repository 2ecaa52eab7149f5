#pragma once

#include <string_view>
#include <vector>

namespace scb {

/// What of a CPU's vector instructions kernels may use. Results are the same bits at every level.
enum class SimdLevel {
    best,    ///< the best that was compiled and that this CPU has
    base,    ///< what every CPU has: on x86-64 a number at a time, for proof; on aarch64 NEON
    sse4,    ///< SSE4.1 and its likes
    avx2,    ///< AVX2, 8 floats
    avx512,  ///< AVX-512, 16 floats
};

/// Those that this CPU has, `best` first.
std::vector<SimdLevel> available_simd_levels();

/// "best", "base", "sse4", "avx2", "avx512".
std::string_view simd_level_name(SimdLevel level);

}  // namespace scb
