#include "tests/portable/golden_counts.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace scb {
namespace {

const char* const stored_path = SCB_SOURCE_DIR "/golden/baselines/counts.txt";

TEST(GoldenCounts, AreTheSameForEveryCompilerBuildTypeAndCpu) {
    const std::string found = golden_counts();
    if (std::getenv("SCB_UPDATE_BASELINES") != nullptr) {
        ASSERT_EQ(std::getenv("CI"), nullptr) << "baselines are not updated where CI is set";
        ASSERT_TRUE(std::ofstream(stored_path, std::ios::binary) << found);
        return;
    }
    std::ostringstream expected;
    expected << std::ifstream(stored_path, std::ios::binary).rdbuf();
    EXPECT_EQ(first_difference(expected.str(), found), "")
        << "SCB_UPDATE_BASELINES=1 stores what is found, where that is meant";
}

TEST(GoldenCounts, FirstDifferenceNamesTheLineAndBothTexts) {
    EXPECT_EQ(first_difference("a\nb\n", "a\nb\n"), "");
    EXPECT_EQ(first_difference("a\nb\nc\n", "a\nB\nC\n"), "line 2\n  expected: b\n  found:    B\n");
    EXPECT_EQ(first_difference("a\nb\n", "a\n"), "line 2\n  expected: b\n  found:    the end\n");
    EXPECT_EQ(first_difference("", "a\n"), "line 1\n  expected: the end\n  found:    a\n");
}

}  // namespace
}  // namespace scb
