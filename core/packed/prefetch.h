#pragma once

#include <hwy/base.h>
#include <hwy/cache_control.h>

#include <cstddef>

#include "scb/packed_hierarchy.h"

namespace scb {

// Always inline: GCC takes a function that does nothing but prefetch for one without any effect,
// and leaves out calls of it.

/// Fetches bytes from there on into the cache, ahead of their use.
HWY_INLINE void prefetch(const char* at, std::size_t bytes) {
    constexpr std::size_t line = 64;
    for (std::size_t k = 0; k < bytes; k += line) hwy::Prefetch(at + k);
}

HWY_INLINE void prefetch_leaf(const float* words) {
    prefetch(reinterpret_cast<const char*>(words), sizeof(float) * PackedLeaf::fetched_words);
}

}  // namespace scb
