#pragma once

#include <vector>

#include "scb/observer.h"

namespace scb {

/// Sorts pairs by a, then b. Least significant digit first; `room` is for copies, and grows as it
/// must.
void sort_pairs(std::vector<IndexPair>& pairs, std::vector<IndexPair>& room);

}  // namespace scb
