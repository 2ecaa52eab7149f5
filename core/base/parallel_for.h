#pragma once

#include <cstddef>
#include <functional>

namespace scb {

/// How many processors this program may run on: at least 1.
int processor_count();

// These functions share work among threads, the calling one included: at most `threads`, which is
// at least 1, and no more than the machine has. All callers in the program share the threads. The
// first exception of the work is thrown here once all threads have ended.

/// Calls `work(0)` to `work(count - 1)`, each once and in no order.
void parallel_for(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

/// Calls `work(first, end)` for ranges that make up 0 to count - 1, each of at most `block` items.
/// The default suits items that take nanoseconds.
void parallel_blocks(int threads, std::size_t count,
                     const std::function<void(std::size_t, std::size_t)>& work,
                     std::size_t block = 8192);

/// Calls both, at the same time if a thread is free. May be called within either.
void parallel_invoke(int threads, const std::function<void()>& first,
                     const std::function<void()>& second);

/// Calls both halves of a recursion with the number of threads that each may use: at the same time
/// if `shared` and there is more than one thread, else in turn.
template <class First, class Second>
void in_halves(int threads, bool shared, const First& first, const Second& second) {
    if (threads > 1 && shared) {
        parallel_invoke(
            threads, [&] { first(threads); }, [&] { second(threads); });
    } else {
        first(1);
        second(1);
    }
}

}  // namespace scb
