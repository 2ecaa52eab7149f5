#pragma once

#include <hwy/cache_control.h>

#include <cstddef>

#include "core/packed_hierarchy.h"

namespace scb {

/// Fetches bytes from there on into the cache, ahead of their use.
inline void prefetch(const char* at, std::size_t bytes) {
    constexpr std::size_t line = 64;
    for (std::size_t k = 0; k < bytes; k += line) hwy::Prefetch(at + k);
}

inline void prefetch_leaf(const float* words) {
    prefetch(reinterpret_cast<const char*>(words), sizeof(float) * PackedLeaf::fetched_words);
}

}  // namespace scb
