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
    const std::vector<CountRow> rows = count_rows(d, d.sum_a, d.sum_b);
    for (const CountRow& row : rows) names.insert(row.name);
    EXPECT_EQ(names.size(), rows.size());
    for (std::size_t s = 0; s < stage_count; ++s)
        EXPECT_TRUE(names.contains(std::string(stage_name(static_cast<Stage>(s))))) << s;
}

TEST(TraceDiffText, NamesTheFramesThatLoseAllContact) {
    Trace a;
    for (int frame = 0; frame < 12; ++frame) {
        QueryTrace& query = a.frames.emplace_back();
        query.frame = frame;
        query.found.pairs = {{1, 2}, {3, 4}};
    }
    Trace b = a;
    b.frames[3].found.pairs.clear();
    b.frames[5].found.pairs.pop_back();
    b.frames[7].found.n_v = 9;
    const std::string text = trace_diff_text(diff(a, b), {});
    for (const char* line : {"12 frames in both, 3 differ (frames 3, 5, 7)\n",
                             "\n2 frames with other pairs (frames 3, 5)\n",
                             "\n1 frame with the same pairs, but other counts or tests (frame 7)\n",
                             "\n1 frame with contact only in the first (frame 3)\n"})
        EXPECT_NE(text.find(line), std::string::npos) << text;
    EXPECT_NE(trace_diff_text(diff(a, b), {}, 2).find("3 differ (frames 3, 5, ...)"),
              std::string::npos);
    EXPECT_NE(trace_diff_text(diff(b, a), {}).find("contact only in the second (frame 3)"),
              std::string::npos);
}

}  // namespace
}  // namespace scb::scenes
