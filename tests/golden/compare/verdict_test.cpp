#include "golden/compare/verdict.h"

#include <gtest/gtest.h>

namespace scb::golden {
namespace {

constexpr Verdict all[] = {
    Verdict::same,       Verdict::different,     Verdict::size_differs, Verdict::missing_baseline,
    Verdict::new_output, Verdict::could_not_run, Verdict::skipped};

TEST(Verdicts, AreFoundByTheirNames) {
    for (const Verdict verdict : all)
        EXPECT_EQ(verdict_names.find(verdict_names[verdict]), verdict);
    EXPECT_EQ(verdict_names[Verdict::missing_baseline], "missing baseline");
    EXPECT_EQ(verdict_names[Verdict::skipped], "skipped");
    EXPECT_EQ(verdict_names.find("Same"), std::nullopt);
    EXPECT_EQ(verdict_names.find(""), std::nullopt);
}

TEST(Verdicts, AllButSameAndSkippedFail) {
    for (const Verdict verdict : all)
        EXPECT_EQ(is_failure(verdict), verdict != Verdict::same && verdict != Verdict::skipped)
            << verdict_names[verdict];
}

}  // namespace
}  // namespace scb::golden
