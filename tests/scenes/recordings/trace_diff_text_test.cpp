#include "scenes/recordings/trace_diff_text.h"

#include <gtest/gtest.h>

#include <set>

namespace scb::scenes {
namespace {

TEST(CountRows, HaveEveryStageOnce) {
    Trace trace;
    std::vector<Step>& steps = trace.frames.emplace_back().steps.volumes;
    for (std::size_t s = 0; s < stage_count; ++s)
        steps.emplace_back().stage = static_cast<Stage>(s);
    const TraceDiff d = diff(trace, trace);
    std::set<std::string> names;
    const std::vector<CountRow> rows = count_rows(d.sum_a, d.sum_b, d.stages);
    for (const CountRow& row : rows) names.insert(row.name);
    EXPECT_EQ(names.size(), rows.size());
    for (std::size_t s = 0; s < stage_count; ++s)
        EXPECT_TRUE(names.contains(std::string(stage_name(static_cast<Stage>(s))))) << s;
}

}  // namespace
}  // namespace scb::scenes
