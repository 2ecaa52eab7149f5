#pragma once

#include <vector>

#include "scb/observer.h"

namespace scb {

/// Sorts pairs by a, then b: a radix sort, least significant digit first. `room`: scratch space,
/// resized as needed.
void sort_pairs(std::vector<IndexPair>& pairs, std::vector<IndexPair>& room);

}  // namespace scb
