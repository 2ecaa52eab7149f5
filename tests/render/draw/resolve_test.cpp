#include "render/draw/resolve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "core/base/random.h"

namespace scb::render {
namespace {

constexpr std::size_t target_width = 300;

std::vector<std::uint32_t> random_words(std::size_t count) {
    Random random(7);
    std::vector<std::uint32_t> words(count);
    for (std::uint32_t& word : words)
        for (int shift = 0; shift < 32; shift += 8) {
            const double u = random.uniform(-0.2, 1.2);  // often one of the ends
            word |= static_cast<std::uint32_t>(u < 0 ? 0 : u > 1 ? 255 : 255 * u) << shift;
        }
    return words;
}

/// As they are in memory: r, g, b, a.
std::array<std::uint8_t, 4> bytes(std::uint32_t word) {
    return std::bit_cast<std::array<std::uint8_t, 4>>(word);
}

TEST(Resolve, ColorsAreTheRoundedMeanOfTheirSamplesAndOpaque) {
    for (const int scale : {1, 2}) {
        const auto step = static_cast<std::size_t>(scale);
        const std::vector<std::uint32_t> samples = random_words(step * step * target_width);
        std::vector<std::uint32_t> row(target_width);
        resolve_colors(samples.data(), scale, row);
        for (std::size_t x = 0; x < target_width; ++x)
            for (std::size_t channel = 0; channel < 4; ++channel) {
                std::uint32_t sum = 0;
                for (std::size_t i = 0; i < step; ++i)
                    for (std::size_t k = 0; k < step; ++k)
                        sum += bytes(samples[i * step * target_width + step * x + k])[channel];
                const std::uint32_t count = scale == 1 ? 1 : 4;
                ASSERT_EQ(bytes(row[x])[channel], channel == 3 ? 255 : (sum + count / 2) / count)
                    << x;
            }
    }
}

TEST(Resolve, AnIdIsThatOfOneSample) {
    const std::vector<std::uint32_t> samples = random_words(4 * target_width);
    std::vector<std::uint32_t> row(target_width);
    resolve_ids(samples.data(), 1, row);
    EXPECT_TRUE(std::equal(row.begin(), row.end(), samples.begin()));
    resolve_ids(samples.data(), 2, row);
    for (std::size_t x = 0; x < target_width; ++x)
        ASSERT_EQ(row[x], samples[2 * target_width + 2 * x]);
}

}  // namespace
}  // namespace scb::render
