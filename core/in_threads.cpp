#include "core/in_threads.h"

#include <algorithm>
#include <map>
#include <mutex>

#ifndef SCB_WITHOUT_TBB
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>
#endif

namespace scb {

#ifndef SCB_WITHOUT_TBB
namespace {

// One for each number of threads, kept: it takes workers some fifty microseconds to come to an
// arena that was just made.
tbb::task_arena& arena_of(int threads) {
    static std::mutex mutex;
    static std::map<int, tbb::task_arena> arenas;
    const std::lock_guard lock(mutex);
    return arenas.try_emplace(threads, threads).first->second;
}

}  // namespace

void in_threads(int threads, std::size_t count, const std::function<void(std::size_t)>& work) {
    arena_of(threads).execute([&] {
        // Each by itself: they are few, and of unlike size.
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const tbb::blocked_range<std::size_t>& range) {
                for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
            },
            tbb::simple_partitioner());
    });
}

void both(int threads, const std::function<void()>& first, const std::function<void()>& second) {
    if (threads == 1) {
        first();
        second();
        return;
    }
    arena_of(threads).execute([&] { tbb::parallel_invoke(first, second); });
}
#else
void in_threads(int, std::size_t count, const std::function<void(std::size_t)>& work) {
    for (std::size_t i = 0; i < count; ++i) work(i);
}

void both(int, const std::function<void()>& first, const std::function<void()>& second) {
    first();
    second();
}
#endif

void in_blocks(int threads, std::size_t count,
               const std::function<void(std::size_t, std::size_t)>& work) {
    constexpr std::size_t block = 8192;
    if (threads == 1 || count <= block) return work(0, count);
    in_threads(threads, (count + block - 1) / block,
               [&](std::size_t i) { work(i * block, std::min(count, (i + 1) * block)); });
}

}  // namespace scb
