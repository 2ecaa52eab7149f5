#pragma once

#include <cstddef>
#include <functional>

namespace scb {

/// Calls `work(0)` to `work(count - 1)`, each once and in no order, in so many threads at most,
/// this one included. `work` throws nothing, here and below.
void in_threads(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

/// Calls `work(first, end)` for ranges that make up 0 to count - 1, as in_threads does.
void in_blocks(int threads, std::size_t count,
               const std::function<void(std::size_t, std::size_t)>& work);

/// Calls both, at the same time where one of so many threads is free. May be called within either.
void both(int threads, const std::function<void()>& first, const std::function<void()>& second);

}  // namespace scb
