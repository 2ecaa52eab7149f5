#pragma once

#include <cstddef>
#include <functional>

namespace scb::golden {

/// Calls `work(i)` for 0 to count - 1 in `threads` threads; a free thread takes the next i. Calls
/// `step` after each, one thread at a time; if it returns false, the loop ends. An exception of
/// either ends the loop too, and is thrown here once all threads have ended.
void for_each_in_threads(std::size_t count, std::size_t threads,
                         const std::function<void(std::size_t)>& work,
                         const std::function<bool()>& step);

}  // namespace scb::golden
