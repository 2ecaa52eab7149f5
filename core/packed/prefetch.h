#pragma once

#include <hwy/base.h>
#include <hwy/cache_control.h>

#include <cstddef>

#include "scb/packed_hierarchy.h"

namespace scb {

// Always inline: GCC treats a function that only prefetches as a function without effect, and
// removes calls of it.

/// Fetches `bytes` bytes from `at` on into the cache, before their use.
HWY_INLINE void prefetch(const char* at, std::size_t bytes) {
    constexpr std::size_t line = 64;
    for (std::size_t k = 0; k < bytes; k += line) hwy::Prefetch(at + k);
}

HWY_INLINE void prefetch_leaf(const float* words) {
    prefetch(reinterpret_cast<const char*>(words), sizeof(float) * PackedLeaf::fetched_words);
}

}  // namespace scb
