#include "golden/run/check_cases.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace scb::golden {
namespace {

class ForEachInThreads : public testing::TestWithParam<std::size_t> {};

TEST_P(ForEachInThreads, DoesEachOnce) {
    std::vector<std::atomic<int>> done(50);
    std::size_t steps = 0;
    for_each_in_threads(
        done.size(), GetParam(), [&](std::size_t i) { ++done[i]; }, [&] { return ++steps > 0; });
    for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
    EXPECT_EQ(steps, done.size());
}

TEST_P(ForEachInThreads, EndsWhereAStepSaysSo) {
    std::atomic<std::size_t> done = 0;
    for_each_in_threads(
        1000000, GetParam(), [&](std::size_t) { ++done; }, [] { return false; });
    EXPECT_LE(done, GetParam());
}

TEST_P(ForEachInThreads, ThrowsWhatWorkOrAStepThrows) {
    const auto fail = [] { throw std::runtime_error("full"); };
    EXPECT_THROW(for_each_in_threads(
                     9, GetParam(), [&](std::size_t) { fail(); }, [] { return true; }),
                 std::runtime_error);
    EXPECT_THROW(for_each_in_threads(
                     9, GetParam(), [](std::size_t) {},
                     [&] {
                         fail();
                         return true;
                     }),
                 std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(, ForEachInThreads, testing::Values(1, 2, 8));

}  // namespace
}  // namespace scb::golden
