#include <gtest/gtest.h>

#include "core/platform/file_bytes.h"
#include "tests/scenes/recordings/record_everything.h"
#include "tests/scenes/recordings/sample_records.h"
#include "tests/temporary_folder.h"

extern "C" {
int record_everything_in_c(const char* path);
int record_and_crash(const char* path);
int record_nowhere(const char* path);
int record_off();
}

namespace scb::scenes {
namespace {

template <class R>
std::vector<R> all_of(const std::vector<Record>& records) {
    std::vector<R> found;
    for (const Record& record : records)
        if (const R* r = std::get_if<R>(&record)) found.push_back(*r);
    return found;
}

TEST(Recorder, WritesTheSameInCAndInCpp) {
    const TemporaryFolder folder;
    EXPECT_EQ(record_everything_in_c((folder / "c.scbrec").c_str()), 0);
    EXPECT_EQ(record_everything((folder / "cpp.scbrec").c_str()), 0);
    EXPECT_EQ(file_bytes(folder / "c.scbrec"), file_bytes(folder / "cpp.scbrec"));
}

TEST(Recorder, IsReadBackAsItWasCalled) {
    const TemporaryFolder folder;
    ASSERT_EQ(record_everything((folder / "x.scbrec").c_str()), 0);
    std::string damage;
    const std::vector<Record> records = records_of(file_bytes(folder / "x.scbrec"), &damage);
    EXPECT_EQ(damage, "");
    EXPECT_EQ(all_of<RecordedSetting>(records),
              (std::vector<RecordedSetting>{{"engine", "test 1.0"}, {"margin", "0.04"}}));
    EXPECT_EQ(all_of<RecordedStage>(records),
              (std::vector<RecordedStage>{{1, "axis of A"}, {127, ""}}));
    const RecordedMesh tetra{
        3, "tetra", 4, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 2, 0, 1, 3}},
        one{4, "one", 8, {0, 0, 0, 0.1, 0, 0, 0, 0.1, 0}, {0, 1, 2}},
        wide{5, "wide", 8, {0, 0, 0, 0.1, 0, 0, 0, 0.1, 0}, {0, 1, UINT32_MAX}};
    EXPECT_EQ(all_of<RecordedMesh>(records), (std::vector<RecordedMesh>{tetra, one, wide}));
    EXPECT_EQ(all_of<RecordedTree>(records),
              (std::vector<RecordedTree>{
                  {7, 3, "boxes", {}}, {8, record_none, "objects", {1, 0, 0, 0, 1, 0, 0, 0, 1}}}));
    const RecordedVolume box{RecordedKind::aabb, {0, 0, 0, 1, 1, 1}},
        ball{RecordedKind::ball, {0, 0, 0, 1}}, slabs{RecordedKind::kdop, {0, 1, 0, 1, 0, 1}};
    const std::uint64_t id = 0xfedcba9876543210;
    EXPECT_EQ(all_of<RecordedNode>(records),
              (std::vector<RecordedNode>{{7, 0, record_none, id, "root", {1, 2}, {}, box},
                                         {7, 1, 0, id, "", {}, {0}, ball},
                                         {7, 2, 0, id, "", {}, {1}, ball},
                                         {8, 0, record_none, id, "", {}, {1}, slabs}}));
    EXPECT_EQ(all_of<RecordedBody>(records), (std::vector<RecordedBody>{{0, 7, "A"}, {1, 7, "B"}}));
    EXPECT_EQ(all_of<RecordedFrame>(records), (std::vector<RecordedFrame>{{0}, {1}}));
    const RecordedPose pose{1, {1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0}};
    EXPECT_EQ(all_of<RecordedPose>(records), (std::vector<RecordedPose>{pose, pose}));
    EXPECT_EQ(all_of<RecordedRefit>(records),
              (std::vector<RecordedRefit>{{7, 1, box}, {7, 1, box}}));
    EXPECT_EQ(all_of<RecordedQuery>(records),
              (std::vector<RecordedQuery>{{0, 1}, {0, 1, true, "lift", {"grasp", "slow"}}}));
    EXPECT_EQ(all_of<RecordedLog>(records), (std::vector<RecordedLog>{{"gripper closed"}}));
    EXPECT_EQ(all_of<RecordedQueryEnd>(records),
              (std::vector<RecordedQueryEnd>{{true, 123456789012345}, {true, 123456789012345}}));
    EXPECT_EQ(all_of<RecordedEnd>(records).size(), 1u);

    EXPECT_EQ(all_of<RecordedMeasure>(records),
              (std::vector<RecordedMeasure>{{1, 2.5, 0.125}, {2, 0.375, 0}}));
    EXPECT_EQ(all_of<RecordedAnswer>(records),
              (std::vector<RecordedAnswer>{{0.5, 1, 0, {1, 0, 0, 0.5, 0, 1}},
                                           {1.5, record_none, record_none, {}}}));

    std::vector<RecordedEvent> expected = {{0, 0, 0}};
    for (std::uint32_t k = 0; k < 10'000; ++k)
        expected.push_back({static_cast<std::uint8_t>(k % 2), k, 2});
    expected.insert(expected.end(),
                    {{131, 7, 0}, {127, 2, 1}, {129, 0, 1}, {128, 1, 1}, {130, 0, 1}});
    const std::vector<RecordedEvent> once = expected;
    expected.insert(expected.begin(),
                    {recorded_length(0.75), {3, 0, 2}, recorded_length(-0.25), {128, 1, 0}});
    expected.insert(expected.end(), once.begin(), once.end());
    EXPECT_EQ(all_of<RecordedEvent>(records), expected);
}

TEST(Recorder, LeavesWhatItFlushedWhereAProgramCrashes) {
    const TemporaryFolder folder;
    ASSERT_EQ(record_and_crash((folder / "x.scbrec").c_str()), 0);
    std::string damage;
    const std::vector<Record> records = records_of(file_bytes(folder / "x.scbrec"), &damage);
    ASSERT_EQ(records.size(), 4u);
    EXPECT_EQ(std::get<RecordedMesh>(records[1]).coordinates.back(), 89'999);
    EXPECT_EQ(std::get<RecordedQuery>(records[3]), (RecordedQuery{0, 0}));
    EXPECT_EQ(damage,
              "x.scbrec ends without the record that scb_record_close writes; all whole blocks "
              "were read.");
}

TEST(Recorder, SaysAtTheEndWhatWentWrong) {
    EXPECT_EQ(record_nowhere("/no/such/folder/x.scbrec"), ENOENT);
    EXPECT_EQ(record_everything("/dev/full"), ENOSPC);
    EXPECT_EQ(record_off(), 0);
}

}  // namespace
}  // namespace scb::scenes
