#include "render/plots/plot_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace scb::render {
namespace {

std::vector<std::string> labels(const PlotAxis& axis) {
    std::vector<std::string> result;
    for (const AxisTick& tick : axis.ticks)
        if (!tick.label.empty()) result.push_back(tick.label);
    return result;
}

using Labels = std::vector<std::string>;

TEST(LinearAxis, HasRoundMarks) {
    const auto grown = [](double low, double high, int most) {
        return labels(linear_axis(low, high, most, AxisEnds::ticks));
    };
    EXPECT_EQ(grown(0, 9.3, 6), (Labels{"0", "2", "4", "6", "8", "10"}));
    EXPECT_EQ(grown(0, 0.3, 4), (Labels{"0", "0.1", "0.2", "0.3"}));
    EXPECT_EQ(grown(-3, 4, 5), (Labels{"-4", "-2", "0", "2", "4"}));
    EXPECT_EQ(grown(0, 9000, 6), (Labels{"0", "2k", "4k", "6k", "8k", "10k"}));
    EXPECT_EQ(grown(0, 4100, 6), (Labels{"0", "1,000", "2,000", "3,000", "4,000", "5,000"}));
    EXPECT_EQ(grown(0, 2.6e6, 7), (Labels{"0", "0.5M", "1.0M", "1.5M", "2.0M", "2.5M", "3.0M"}));
    EXPECT_EQ(grown(-2e9, 2e9, 3), (Labels{"-2G", "0", "2G"}));
    EXPECT_EQ(grown(1000000, 1000004, 5),
              (Labels{"1,000,000", "1,000,001", "1,000,002", "1,000,003", "1,000,004"}));
}

TEST(LinearAxis, EndsAtTheDataWhereAsked) {
    const PlotAxis axis = linear_axis(0, 499, 6, AxisEnds::data);
    EXPECT_EQ(axis.low, 0);
    EXPECT_EQ(axis.high, 499);
    EXPECT_EQ(labels(axis), (Labels{"0", "100", "200", "300", "400"}));
}

TEST(LinearAxis, MarksWholeNumbersOnlyWhereAsked) {
    EXPECT_EQ(labels(linear_axis(3, 5, 9, AxisEnds::data, true)), (Labels{"3", "4", "5"}));
    const PlotAxis one = linear_axis(250, 250, 9, AxisEnds::data, true);
    EXPECT_EQ(labels(one), Labels{"250"});
    EXPECT_EQ(axis_position(one, 250), 0.5);
}

TEST(LinearAxis, CoversAnyRangeWithFewDifferentMarks) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const auto& [low, high] : {std::pair{0.0, 1.0},
                                    {0.0, 0.0},
                                    {5.0, 5.0},
                                    {-5.0, -5.0},
                                    {1.0, 1.0 + 1e-15},
                                    {1.0, 1.0 + 3e-9},
                                    {1e9, 1e9 + 7},
                                    {-1e-7, 3e-7},
                                    {3e-200, 4e-200},
                                    {0.0, 5e-324},
                                    {-1.7e308, 1.7e308},
                                    {1e300, 1e300},
                                    {-12345.678, -0.001},
                                    {7.0, -7.0},
                                    {-infinity, infinity}})
        for (const int most : {0, 3, 6, 9})
            for (const AxisEnds ends : {AxisEnds::data, AxisEnds::ticks}) {
                const PlotAxis axis = linear_axis(low, high, most, ends);
                const std::string what = std::to_string(low) + " " + std::to_string(high);
                EXPECT_LT(axis.low, axis.high) << what;
                EXPECT_TRUE(std::isfinite(axis.high - axis.low)) << what;
                const double limit = 1e300;
                if (std::isfinite(low) && std::isfinite(high)) {
                    EXPECT_LE(axis.low, std::max(std::min(low, high), -limit)) << what;
                    EXPECT_GE(axis.high, std::min(std::max(low, high), limit)) << what;
                }
                EXPECT_GE(axis.ticks.size(), ends == AxisEnds::ticks ? 2u : 1u) << what;
                EXPECT_LE(axis.ticks.size(), static_cast<std::size_t>(std::max(most, 3))) << what;
                std::set<std::string> seen;
                double last = -infinity;
                for (const AxisTick& tick : axis.ticks) {
                    EXPECT_GT(tick.value, last) << what;
                    EXPECT_TRUE(seen.insert(tick.label).second) << what << " " << tick.label;
                    last = tick.value;
                }
            }
}

TEST(LinearAxis, StepsAreOneTwoOrFive) {
    for (double high = 1e-6; high < 1e7; high *= 1.37) {
        const PlotAxis axis = linear_axis(0, high, 7, AxisEnds::ticks);
        const double step = axis.ticks[1].value - axis.ticks[0].value;
        const double leading = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
        EXPECT_TRUE(std::abs(leading - 1) < 1e-9 || std::abs(leading - 2) < 1e-9 ||
                    std::abs(leading - 5) < 1e-9)
            << high << " " << step;
        EXPECT_GE(axis.ticks.size(), 3u) << high;
    }
}

TEST(LogAxis, MarksPowersOfTenAndMoreWhereThereIsRoom) {
    EXPECT_EQ(labels(log_axis(4000, 2600000, 8)), (Labels{"10k", "100k", "1M"}));
    EXPECT_EQ(labels(log_axis(3, 80, 8)), (Labels{"2", "5", "10", "20", "50", "100"}));
    EXPECT_EQ(labels(log_axis(0.002, 0.01, 8)), (Labels{"0.002", "0.005", "0.01"}));
    EXPECT_EQ(labels(log_axis(1, 1e12, 5)), (Labels{"1", "1k", "1M", "1G", "1e12"}));
    const PlotAxis axis = log_axis(4000, 2600000, 8);
    EXPECT_EQ(axis.low, 2000);
    EXPECT_EQ(axis.high, 5000000);
}

TEST(LogAxis, GivesZeroAPlaceOfItsOwn) {
    const PlotAxis axis = log_axis(10, 1000, 8, true);
    EXPECT_EQ(labels(axis).front(), "0");
    EXPECT_EQ(axis_position(axis, 0), 0);
    EXPECT_GT(axis_position(axis, 10), 0.05);
    EXPECT_TRUE(std::isnan(axis_position(log_axis(10, 1000, 8), 0)));
    EXPECT_TRUE(std::isnan(axis_position(axis, -1)));
}

TEST(LogAxis, CoversAnyRange) {
    for (const auto& [low, high] : {std::pair{1.0, 1.0},
                                    {5e-324, 1.7e308},
                                    {1e-250, 1e250},
                                    {99.9999, 100.0001},
                                    {0.0, 0.0},
                                    {7.0, 3.0}})
        for (const bool zero : {false, true}) {
            const PlotAxis axis = log_axis(low, high, 6, zero);
            EXPECT_GT(axis.low, 0);
            EXPECT_LT(axis.low, axis.high);
            EXPECT_GE(labels(axis).size(), 1u);
            EXPECT_LE(labels(axis).size(), 7u);
        }
    const PlotAxis constant = log_axis(5, 5, 6);
    EXPECT_GT(axis_position(constant, 5), 0.2);
    EXPECT_LT(axis_position(constant, 5), 0.8);
}

TEST(AxisPosition, IsProportionalAndWithinTheAxis) {
    const PlotAxis linear{10, 20, false, false, {}}, logarithmic{1, 1e4, true, false, {}};
    EXPECT_EQ(axis_position(linear, 15), 0.5);
    EXPECT_EQ(axis_position(linear, 5), 0);
    EXPECT_EQ(axis_position(linear, 25), 1);
    EXPECT_EQ(axis_position(logarithmic, 100), 0.5);
    EXPECT_TRUE(std::isnan(axis_position(linear, NAN)));
    EXPECT_TRUE(std::isnan(axis_position(linear, INFINITY)));
}

}  // namespace
}  // namespace scb::render
