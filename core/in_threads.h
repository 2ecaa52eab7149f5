#pragma once

#include <cstddef>
#include <functional>

namespace scb {

/// Calls `work(0)` to `work(count - 1)`, each once and in no order, in so many threads at most,
/// this one included. Where the library was built without TBB, one after the other.
void in_threads(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace scb
