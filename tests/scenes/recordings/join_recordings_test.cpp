#include "scenes/recordings/join_recordings.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "core/platform/file_bytes.h"
#include "scb/error.h"
#include "tests/scenes/recordings/record_everything.h"
#include "tests/scenes/recordings/sample_records.h"
#include "tests/temporary_folder.h"

namespace scb::scenes {
namespace {

using Records = std::vector<Record>;

/// The recordings `a.scbrec`, `b.scbrec`, ... of these bytes, as one.
std::string joined_bytes(const std::vector<std::string>& recordings) {
    std::vector<RecordingReader> readers;
    for (std::size_t i = 0; i < recordings.size(); ++i)
        readers.emplace_back(recordings[i], std::string(1, static_cast<char>('a' + i)) + ".scbrec");
    RecordingWriter writer;
    join_recordings(readers, [&](const Record& record) { writer.add(record); });
    return writer.finish();
}

/// Compared as bytes, since NaN is not what it is.
std::string joined(const std::vector<Records>& recordings) {
    std::vector<std::string> bytes;
    for (const Records& records : recordings) bytes.push_back(recording_of(records));
    return joined_bytes(bytes);
}

std::string refusal(const std::vector<Records>& recordings) {
    try {
        joined(recordings);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

Records operator+(Records a, const Records& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

RecordedVolume ball(double radius) { return {RecordedKind::ball, {0, 0, 0, radius}}; }

RecordedPose at(std::uint32_t body, double x) {
    return {body, {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0}};
}

RecordedNode node(std::uint32_t number, double radius) {
    return {0, number, record_none, 0, "", {}, {0}, ball(radius)};
}

/// A tree of one node, whose volume is nothing that is equal to itself.
Records world() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {RecordedSetting{"engine", "test"},
            RecordedStage{1, "sphere"},
            RecordedMesh{0, "m", 8, {0, 0, nan}, {0, 0, 0}},
            RecordedTree{0, 0, "t", {}},
            node(0, nan),
            RecordedBody{0, 0, "A"},
            RecordedBody{1, 0, "B"}};
}

/// A query whose only test is of this node: they are told apart by it.
Records query(std::uint32_t which) {
    return {RecordedQuery{0, 1}, RecordedEvent{1, which, 0}, RecordedQueryEnd{true, 0}};
}

const Records done = {RecordedEnd{}};

Records frame(std::uint32_t number) { return {RecordedFrame{number}}; }

TEST(JoinRecordings, HandsOnOneAsItIs) {
    Records open = sample_records();
    open.pop_back();
    for (const Records& records : {sample_records(), open + Records{RecordedQuery{0, 0}}})
        EXPECT_EQ(joined({records}), recording_of(records));
}

TEST(JoinRecordings, SaysOnceWhatAllSayAlike) {
    const Records both = frame(0) + Records{at(1, 2)};
    EXPECT_EQ(joined({world() + both + query(1) + done, world() + both + query(2) + done}),
              recording_of(world() + both + query(1) + query(2) + done));
}

TEST(JoinRecordings, KeepsWhatOnlyOneSays) {
    const Records more = {RecordedSetting{"thread", "2"}, RecordedTree{1, record_none, "", {}}};
    EXPECT_EQ(joined({world() + frame(0) + query(1) + done, more + frame(0) + query(2) + done}),
              recording_of(world() + more + frame(0) + query(1) + query(2) + done));
}

TEST(JoinRecordings, DefinesBeforeFramesAndLetsThemAscend) {
    const Records first = frame(1) + query(1) + frame(4) + query(4),
                  second = frame(0) + query(0) + frame(4) + query(5) + frame(7) + query(7);
    EXPECT_EQ(joined({world() + first + done, world() + second + done}),
              recording_of(world() + frame(0) + query(0) + frame(1) + query(1) + frame(4) +
                           query(4) + query(5) + frame(7) + query(7) + done));
}

TEST(JoinRecordings, KeepsTheOrderOfChangesWithinAFrame) {
    // Each thread moves the body and refits the node before each of its queries.
    const auto step = [](std::uint32_t which, double x) {
        return Records{at(1, x), RecordedRefit{0, 0, ball(x)}, RecordedSetting{"margin", "0"}} +
               query(which);
    };
    // Without frames too.
    const Records back = {at(1, 4), RecordedRefit{0, 0, ball(4)}};
    EXPECT_EQ(joined({step(1, 4) + step(2, 5) + done, step(4, 5) + step(5, 4) + done}),
              recording_of(step(1, 4) + step(2, 5) + query(4) + back + query(5) + done));
    const Records again = {at(1, 5), RecordedRefit{0, 0, ball(5)}};
    EXPECT_EQ(
        joined({world() + frame(0) + step(1, 4) + step(2, 5) + frame(1) + again + query(3) + done,
                world() + frame(0) + step(4, 5) + step(5, 4) + frame(1) + again + query(6) + done}),
        recording_of(world() + frame(0) + step(1, 4) + step(2, 5) + query(4) + back + query(5) +
                     frame(1) + again + query(3) + query(6) + done));
}

TEST(JoinRecordings, SaysOnceThatATreeWasBuiltAnew) {
    const Records anew = {RecordedTree{0, 0, "t", {}}, node(0, 3), node(1, 2)};
    const Records rest = frame(5) + anew + query(1);
    EXPECT_EQ(joined({world() + rest + done, world() + rest + done}),
              recording_of(world() + rest + query(1) + done));
    // The second of them builds it in a frame of its own.
    EXPECT_EQ(joined({world() + rest + done, world() + frame(6) + anew + query(2) + done}),
              recording_of(world() + rest + frame(6) + anew + query(2) + done));
}

TEST(JoinRecordings, DefinesNothingAnewThatIsDefinedLate) {
    const Records body = {RecordedBody{1, 0, "B"}};
    EXPECT_EQ(joined({world() + frame(0) + Records{at(1, 2)} + query(1) + done,
                      frame(0) + body + query(2) + done}),
              recording_of(world() + frame(0) + Records{at(1, 2)} + query(1) + query(2) + done));
    // One that becomes another keeps its pose, so that the same pose is not said again.
    const Records other = {RecordedBody{1, 1, "B"}, at(1, 2)};
    EXPECT_EQ(joined({world() + frame(0) + done, frame(0) + Records{at(1, 2)} + done,
                      frame(0) + other + query(2) + done}),
              recording_of(world() + frame(0) + Records{at(1, 2), other[0]} + query(2) + done));
    const Records tree = {RecordedTree{0, 0, "t", {}}, node(0, 1), RecordedRefit{0, 0, ball(2)}};
    EXPECT_EQ(
        joined({world() + frame(0) + Records{tree[2]} + query(1) + done,
                frame(0) + tree + query(2) + done}),
        recording_of(world() + frame(0) + Records{tree[2]} + query(1) + tree + query(2) + done));
}

TEST(JoinRecordings, KeepsANodeThatEachDescribesTwice) {
    const Records twice = world() + Records{node(3, 1), node(3, 2)};
    EXPECT_EQ(joined({twice + done, twice + done}), recording_of(twice + done));
}

TEST(JoinRecordings, EndsAQueryThatOneLeavesOpen) {
    const Records open = {RecordedQuery{0, 1}, RecordedEvent{1, 1, 0}};
    EXPECT_EQ(
        joined({world() + frame(0) + open, world() + frame(0) + query(2) + done}),
        recording_of(world() + frame(0) + open + Records{RecordedQueryEnd{false, 0}} + query(2)));
}

TEST(JoinRecordings, ReadsWhatADamagedOneHas) {
    std::string damaged = recording_of(world() + frame(0) + query(1) + done);
    damaged.resize(damaged.size() - 1);
    EXPECT_EQ(joined_bytes({damaged, recording_of(world() + frame(0) + query(2) + done)}),
              recording_of(world() + frame(0) + query(2)));
}

TEST(JoinRecordings, RefusesWhatContradictsAnother) {
    for (const auto& [name, record] : std::vector<std::pair<std::string, Record>>{
             {"stage 1", RecordedStage{1, "box"}},
             {"mesh 0", RecordedMesh{0, "m", 8, {0, 0, 1}, {0, 0, 0}}},
             {"tree 0", RecordedTree{0, 0, "u", {}}},
             {"node 0 of tree 0", node(0, 1)},
             {"body 1", RecordedBody{1, 1, "B"}}}) {
        EXPECT_EQ(refusal({world() + done, done, Records{record} + done}),
                  "c.scbrec: " + name +
                      " is not that of a.scbrec; give what differs another number in each thread.");
        EXPECT_EQ(refusal({frame(2) + world() + done, frame(2) + Records{record} + done}),
                  "b.scbrec: " + name +
                      " is not that of a.scbrec in frame 2; give what differs another number in "
                      "each thread.");
        // From here on it is another one.
        EXPECT_EQ(refusal({world() + done, frame(2) + Records{record} + done}), "");
    }
}

TEST(JoinRecordings, RefusesFramesThatDoNotAscend) {
    for (const std::uint32_t number : {2u, 1u})
        EXPECT_EQ(refusal({done, frame(2) + frame(number)}),
                  "b.scbrec: frame " + std::to_string(number) +
                      " follows frame 2; record frames in ascending order.");
}

/// A recording of the queries of a thread, of `frames` frames; with `of` 1 of all queries.
void record_thread(const std::string& path, std::uint32_t thread, std::uint32_t of) {
    static const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const unsigned char indices[] = {0, 1, 2};
    static const double box[] = {0, 0, 0, 1, 1, 0};
    const std::uint32_t items[] = {0};
    scb_record_node_data root = {SCB_RECORD_NONE,          0, "root", nullptr, 0, items, 1,
                                 {SCB_RECORD_AABB, 6, box}};
    scb_recorder r;
    EXPECT_EQ(scb_record_open(&r, path.c_str(), "threads"), 0);
    scb_record_mesh(&r, 0, "triangle", corners, 4, 0, 3, indices, 1, 1);
    scb_record_tree(&r, 0, "tree", 0, nullptr, 0);
    scb_record_node(&r, 0, 0, &root);
    scb_record_body(&r, 0, "A", 0);
    scb_record_body(&r, 1, "B", 0);
    for (std::uint32_t k = 0; k < 20; ++k) {
        const double pose[] = {1, 0, 0, 0.1 * k, 0, 1, 0, 0, 0, 0, 1, 0};
        scb_record_frame(&r, k);
        scb_record_pose(&r, 1, pose);
        for (std::uint32_t q = thread * 12 / of; q < (thread + 1) * 12 / of; ++q) {
            scb_record_query(&r, 0, 1);
            for (std::uint32_t i = 0; i < 500; ++i) scb_record_test(&r, q, i, 1);
            scb_record_query_end(&r, 1, q);
        }
    }
    EXPECT_EQ(scb_record_close(&r), 0);
}

TEST(JoinRecordings, OfThreadsAreThatOfOneThread) {
    const TemporaryFolder folder;
    std::vector<std::thread> threads;
    for (std::uint32_t i = 0; i < 3; ++i)
        threads.emplace_back([&, i] { record_thread(folder / std::to_string(i), i, 3); });
    for (std::thread& thread : threads) thread.join();
    record_thread(folder / "all", 0, 1);
    std::vector<std::string> recordings;
    for (int i = 0; i < 3; ++i) recordings.push_back(file_bytes(folder / std::to_string(i)));
    EXPECT_EQ(joined_bytes(recordings), recording_of(records_of(file_bytes(folder / "all"))));
}

}  // namespace
}  // namespace scb::scenes
