#include "core/base/parallel_for.h"

#include <algorithm>

#ifdef SCB_WITHOUT_TBB
#include <atomic>
#include <exception>
#include <optional>
#include <system_error>
#include <thread>
#else
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <map>
#include <mutex>
#endif

namespace scb {

#ifndef SCB_WITHOUT_TBB
int processor_count() { return tbb::info::default_concurrency(); }

namespace {

// One arena for each number of threads, kept: workers take some fifty microseconds to join a new
// arena.
tbb::task_arena& arena_of(int threads) {
    static std::mutex mutex;
    static std::map<int, tbb::task_arena> arenas;
    const std::lock_guard lock(mutex);
    // TBB refuses more threads than CPUs with a warning on standard error.
    const int used = std::min(threads, processor_count());
    return arenas.try_emplace(used, used).first->second;
}

// Isolated: a short query that waits for its own tasks does not run tasks of a long build.
template <class Work>
void in_arena(int threads, const Work& work) {
    arena_of(threads).execute([&] { tbb::this_task_arena::isolate(work); });
}

}  // namespace

void parallel_for(int threads, std::size_t count, const std::function<void(std::size_t)>& work) {
    in_arena(threads, [&] {
        // One task for each call: they are few, and of unlike size.
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const tbb::blocked_range<std::size_t>& range) {
                for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
            },
            tbb::simple_partitioner());
    });
}

void parallel_invoke(int threads, const std::function<void()>& first,
                     const std::function<void()>& second) {
    if (threads == 1) {
        first();
        second();
        return;
    }
    in_arena(threads, [&] { tbb::parallel_invoke(first, second); });
}
#else
int processor_count() {
    return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

namespace {

// Threads beside the first, in the whole program.
std::atomic<int> others = 0;

// Runs `work` in another thread while this one does `own`, if there are not enough already.
void beside(int threads, const std::function<void()>& work, const std::function<void()>& own) {
    if (others.fetch_add(1) >= threads - 1) {
        others.fetch_sub(1);
        own();
        work();
        return;
    }
    std::exception_ptr thrown, thrown_there;
    const auto caught = [](const std::function<void()>& call, std::exception_ptr& by) {
        try {
            call();
        } catch (...) {
            by = std::current_exception();
        }
    };
    std::optional<std::thread> other;
    try {
        other.emplace([&] { caught(work, thrown_there); });
    } catch (const std::system_error&) {  // no more threads: one after the other
    }
    caught(own, thrown);
    if (other)
        other->join();
    else
        caught(work, thrown_there);
    others.fetch_sub(1);
    if (thrown) std::rethrow_exception(thrown);
    if (thrown_there) std::rethrow_exception(thrown_there);
}

}  // namespace

void parallel_for(int threads, std::size_t count, const std::function<void(std::size_t)>& work) {
    if (count == 0) return;
    std::atomic<std::size_t> next = 0;
    const std::function<void()> some = [&] {
        for (std::size_t i = next++; i < count; i = next++) work(i);
    };
    const std::function<void(int)> run = [&](int more) {
        if (more == 0)
            some();
        else
            beside(threads, some, [&] { run(more - 1); });
    };
    run(static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(threads), count)) - 1);
}

void parallel_invoke(int threads, const std::function<void()>& first,
                     const std::function<void()>& second) {
    beside(threads, second, first);
}
#endif

void parallel_blocks(int threads, std::size_t count,
                     const std::function<void(std::size_t, std::size_t)>& work, std::size_t block) {
    if (threads == 1 || count <= block) return work(0, count);
    parallel_for(threads, (count + block - 1) / block,
                 [&](std::size_t i) { work(i * block, std::min(count, (i + 1) * block)); });
}

}  // namespace scb
