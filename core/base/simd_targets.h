#pragma once

#include <cstddef>

#include "scb/simd_level.h"

// Disables targets that SimdLevel does not have, since each costs time to build. Include this
// before <hwy/foreach_target.h>, which includes a file once for each target, and before
// <hwy/highway.h> in files of one target.
#define HWY_DISABLED_TARGETS \
    (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)

namespace scb {

/// The index of the best allowed target in Highway's dispatch table. Unlike HWY_DYNAMIC_DISPATCH,
/// the choice is not for the whole program.
std::size_t simd_target_index(SimdLevel level);

}  // namespace scb

/// The function that HWY_EXPORT(name) has exported, for a level.
#define SCB_AT_LEVEL(name, level) (HWY_DISPATCH_TABLE(name)[simd_target_index(level)])
