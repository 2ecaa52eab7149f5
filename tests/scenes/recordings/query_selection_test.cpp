#include <gtest/gtest.h>

#include "scb/error.h"
#include "scenes/recordings/judgement_words.h"
#include "scenes/recordings/recording_json.h"
#include "tests/scenes/recordings/judged_recordings.h"
#include "tests/scenes/recordings/small_records.h"

namespace scb::scenes {
namespace {

/// A query with one test, which ends at the stage.
std::vector<Record> named_query(const std::string& name, const std::vector<std::string>& tags,
                                std::uint8_t stage) {
    return {RecordedQuery{0, 1, true, name, tags}, RecordedEvent{stage, 0, 0}, RecordedQueryEnd{}};
}

/// Of two balls that overlap, the query "lift" rejects the pair, which is wrong.
std::vector<Record> records() {
    std::vector<Record> all = two_balls();
    append(all, {RecordedFrame{0}, pose_at(1, 1), RecordedLog{"gripper closed"}});
    append(all, named_query("rest", {}, 0));
    append(all, named_query("lift", {"grasp"}, 1));
    append(all, {RecordedFrame{1}, RecordedLog{"gripper open"}});
    append(all, named_query("drop", {"grasp", "slow"}, 0));
    return all;
}

std::string bytes_of(const std::vector<Record>& all) {
    RecordingWriter writer;
    for (const Record& record : all) writer.add(record);
    return writer.finish();
}

RecordingJudgement judged(const std::vector<Record>& all, const QuerySelection& selection) {
    const RecordingFile file(bytes_of(all), "test.scbrec", selection);
    return judge_recording(
        file, [](int) { return true; }, [](bool) { return true; });
}

TEST(QuerySelection, ChoosesByNameAndByTag) {
    const std::vector<std::pair<QuerySelection, std::uint64_t>> expected = {
        {{}, 3}, {{"lift", ""}, 1}, {{"", "grasp"}, 2}, {{"drop", "slow"}, 1}};
    for (const auto& [selection, queries] : expected) {
        const RecordingJudgement found = judged(records(), selection);
        EXPECT_EQ(found.summary.queries, queries) << selection.words();
        EXPECT_EQ(found.summary.volume_tests, queries) << selection.words();
        EXPECT_EQ(found.total(&FrameJudgement::queries), queries) << selection.words();
        EXPECT_EQ(found.total(&FrameJudgement::volume_tests), queries) << selection.words();
    }
    EXPECT_EQ(judged(records(), {"", "slow"}).summary.frames, std::vector{1});
    EXPECT_TRUE(judged(records(), {}).wrong());
    EXPECT_TRUE(judged(records(), {"lift", ""}).wrong());
    EXPECT_FALSE(judged(records(), {"rest", ""}).wrong());
    EXPECT_FALSE(judged(records(), {"", "slow"}).wrong());
}

TEST(QuerySelection, RefusesWithTheKnownNamesOrTags) {
    const auto error_of = [](const QuerySelection& selection) -> std::string {
        try {
            judged(records(), selection);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(error_of({"lif", ""}),
              "--query lif: test.scbrec has no such query; its names are drop, lift, rest.");
    EXPECT_EQ(error_of({"", "gras"}),
              "--tag gras: test.scbrec has no such query; its tags are grasp, slow.");
    EXPECT_EQ(error_of({"rest", "grasp"}),
              "--query rest --tag grasp: test.scbrec has no such query; its tags are grasp, slow.");
}

TEST(QuerySelection, LeavesOutAQueryInWhichTheFileBreaksOff) {
    std::vector<Record> all = records();
    all.pop_back();
    EXPECT_EQ(judged(all, {"lift", ""}).summary.queries, 1u);
    EXPECT_EQ(judged(all, {"lift", ""}).total(&FrameJudgement::queries), 1u);
    EXPECT_EQ(judged(all, {"drop", ""}).total(&FrameJudgement::queries), 1u);
}

TEST(Judgement, NamesTheQueryAndKeepsTheLogOfTheFrame) {
    const RecordingJudgement found = judge(records());
    ASSERT_EQ(found.test_problems.size(), 1u);
    EXPECT_EQ(query_words(found.test_problems[0].cases[0].query), "frame 0, A and B (\"lift\")");
    ASSERT_EQ(found.frames.size(), 2u);
    EXPECT_EQ(found.frames[0].log, std::vector<std::string>{"gripper closed"});
    EXPECT_TRUE(found.frames[1].log.empty()) << "nothing is wrong there";
}

TEST(RecordingJson, HasTheNamesTagsAndLog) {
    const std::string bytes = bytes_of(records()), json = recording_as_json(bytes, "test");
    EXPECT_NE(json.find("{\"query\":[0,1],\"name\":\"lift\",\"tags\":[\"grasp\"]}"),
              std::string::npos)
        << json;
    EXPECT_NE(json.find("{\"log\":\"gripper closed\"}"), std::string::npos) << json;
    EXPECT_EQ(records_in(recording_of_json(json, "test")), records_in(bytes));
}

}  // namespace
}  // namespace scb::scenes
