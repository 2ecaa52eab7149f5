#pragma once

#include <cstddef>
#include <functional>

namespace scb::golden {

/// Calls `work(i)` for 0 to count - 1 in so many threads, each the next one that is free, and
/// `step` after each, one thread at a time, which ends it by returning false. What either throws
/// ends it too, and is thrown from here once all threads have ended.
void for_each_in_threads(std::size_t count, std::size_t threads,
                         const std::function<void(std::size_t)>& work,
                         const std::function<bool()>& step);

}  // namespace scb::golden
