#include "core/base/parallel_for.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace scb {
namespace {

TEST(ParallelFor, CountsTheProcessorsThatItMayRunOn) {
    EXPECT_GE(processor_count(), 1);
    EXPECT_LE(processor_count(),
              std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
}

TEST(ParallelFor, CallsEachOnce) {
    for (const int threads : {1, 2, 7})
        for (const std::size_t count : {0u, 1u, 2u, 3u, 1000u}) {
            std::vector<std::atomic<int>> calls(count);
            parallel_for(threads, count, [&](std::size_t i) { ++calls[i]; });
            for (const auto& call : calls) EXPECT_EQ(call, 1);
        }
}

TEST(ParallelFor, BlocksMakeUpAll) {
    for (const int threads : {1, 2, 7})
        for (const std::size_t count : {0u, 1u, 8192u, 8193u, 100000u}) {
            std::atomic<std::size_t> sum = 0;
            parallel_blocks(threads, count,
                            [&](std::size_t first, std::size_t end) { sum += end - first; });
            EXPECT_EQ(sum, count);
        }
}

int leaves(int threads, int depth) {
    if (depth == 0) return 1;
    int first = 0, second = 0;
    parallel_invoke(
        threads, [&] { first = leaves(threads, depth - 1); },
        [&] { second = leaves(threads, depth - 1); });
    return first + second;
}

TEST(ParallelFor, BothMayBeNested) {
    for (const int threads : {1, 2, 5}) EXPECT_EQ(leaves(threads, 9), 512);
}

TEST(ParallelFor, ThrowsWhatWasThrown) {
    const auto fail = [] { throw std::runtime_error("on purpose"); };
    const auto succeed = [] {};
    for (const int threads : {1, 2, 5}) {
        EXPECT_THROW(parallel_invoke(threads, fail, succeed), std::runtime_error);
        EXPECT_THROW(parallel_invoke(threads, succeed, fail), std::runtime_error);
        EXPECT_THROW(parallel_for(threads, 10,
                                  [&](std::size_t i) {
                                      if (i == 3) fail();
                                  }),
                     std::runtime_error);
        EXPECT_EQ(leaves(threads, 5), 32);  // and goes on after that
    }
}

TEST(ParallelFor, SeveralMayCallAtOnce) {
    std::vector<std::thread> callers;
    std::atomic<int> sum = 0;
    for (int i = 0; i < 4; ++i)
        callers.emplace_back([&] {
            for (int k = 0; k < 20; ++k) sum += leaves(2, 6);
        });
    for (std::thread& caller : callers) caller.join();
    EXPECT_EQ(sum, 4 * 20 * 64);
}

}  // namespace
}  // namespace scb
