#include "core/in_threads.h"

#include <algorithm>

#ifndef SCB_WITHOUT_TBB
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>
#endif

namespace scb {

#ifndef SCB_WITHOUT_TBB
void in_threads(int threads, std::size_t count, const std::function<void(std::size_t)>& work) {
    tbb::task_arena arena(threads);
    arena.execute([&] {
        // Each by itself: they are few, and of unlike size.
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const tbb::blocked_range<std::size_t>& range) {
                for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
            },
            tbb::simple_partitioner());
    });
}

void with_threads(int threads, const std::function<void()>& work) {
    if (threads == 1) return work();
    tbb::task_arena(threads).execute(work);
}

void both(const std::function<void()>& first, const std::function<void()>& second) {
    tbb::parallel_invoke(first, second);
}
#else
void in_threads(int, std::size_t count, const std::function<void(std::size_t)>& work) {
    for (std::size_t i = 0; i < count; ++i) work(i);
}

void with_threads(int, const std::function<void()>& work) { work(); }

void both(const std::function<void()>& first, const std::function<void()>& second) {
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
