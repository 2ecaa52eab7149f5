#pragma once

#include <cstddef>

#include "scb/simd_level.h"

// The targets that kernels are compiled for, besides what every CPU has: each costs as much time to
// build. To be included before <hwy/foreach_target.h>, which includes a file once for each.
#define HWY_DISABLED_TARGETS \
    (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)

namespace scb {

/// Where Highway's dispatch table has the best target that is allowed. Unlike HWY_DYNAMIC_DISPATCH,
/// this is no choice for the whole program.
std::size_t simd_target_index(SimdLevel level);

}  // namespace scb

/// The function that HWY_EXPORT(name) has exported, for a level.
#define SCB_AT_LEVEL(name, level) (HWY_DISPATCH_TABLE(name)[simd_target_index(level)])
