#include "scenes/recordings/trace_file.h"

#include <gtest/gtest.h>

#include "scenes/scene/load_scene.h"
#include "tests/scenes/recordings/trace_bytes.h"

namespace scb::scenes {
namespace {

TEST(TraceFile, GivesBackWhatItWasGiven) {
    std::vector<TraceHeader> headers;
    for (const VolumeKind kind : all_volume_kinds()) headers.push_back(asking(kind, {}));
    for (const OverlapTest test : all_overlap_tests())
        headers.push_back(asking(VolumeKind::scb, test));
    for (const DescentRule rule : all_descent_rules()) {
        headers.push_back(asking(VolumeKind::scb, OverlapTest::extents));
        headers.back().options.descent = rule;
    }
    for (const std::size_t pairs : std::vector<std::size_t>{1, 2, 3, 5, 8}) {
        headers.push_back(asking(VolumeKind::ball, {}));
        headers.back().options.max_pairs = pairs;
        headers.push_back(headers.back());
        headers.back().options.stop_level = 4;
    }
    for (const int level : {0, 1, 2, 5, 9, 40}) {
        headers.push_back(asking(VolumeKind::obb, {}));
        headers.back().options.stop_level = level;
    }
    headers.back().growth = BallGrowth::radius;
    headers.push_back(headers.back());
    headers.back().split = SplitMethod::cost;
    headers.push_back(headers.front());
    headers.back().split = SplitMethod::cost;
    headers.back().margin = 0.125;
    headers.back().options.overlap.threshold = 0.3;
    for (const VolumeKind kind : {VolumeKind::scb, VolumeKind::obb}) {
        headers.push_back(asking_self(kind));
        headers.push_back(headers.back());
        headers.back().options.max_pairs = 3;
        headers.push_back(asking_self(kind));
        headers.back().options.stop_level = 4;
    }
    for (const TraceHeader& header : headers) {
        const Trace trace = small_trace(header);
        const Bytes bytes = encode_trace(trace);
        EXPECT_TRUE(starts_as_trace(bytes));
        const Trace again = decode_trace(bytes, "file");
        expect_same(trace, again);
        const Bytes of_1_0 = trace_file_1_0(trace.header, plain_frames(trace));
        EXPECT_TRUE(starts_as_trace(of_1_0));
        expect_same(trace, decode_trace(of_1_0, "file"));
        EXPECT_EQ(encode_trace(again), bytes);
    }
}

TEST(TraceFile, GivesBackDistancesInAnyOrder) {
    for (const VolumeKind kind : all_volume_kinds())
        for (const Trace& trace : distance_traces(kind)) {
            const Bytes bytes = encode_trace(trace);
            const Trace again = decode_trace(bytes, "file");
            expect_same(trace, again);
            EXPECT_EQ(encode_trace(again), bytes);
            EXPECT_EQ(header_bytes(again.header), header_bytes(trace.header));
        }
    // These queries have all that a trace can have.
    const std::vector<Trace> traces = distance_traces(VolumeKind::scb2);
    EXPECT_TRUE(traces.back().frames[0].steps.volumes.empty());
    EXPECT_EQ(traces.back().frames[0].nearest->distance, 0);
    EXPECT_GT(traces[9].frames[1].found.pairs.size(), 1u);
    EXPECT_FALSE(traces[5].frames[2].nearest);
    const QueryTrace& far = traces[0].frames[2];
    EXPECT_GT(far.nearest->distance, 0);
    const Outcomes outcomes = outcomes_of(traces[0].header, far);
    EXPECT_GT(std::count(outcomes.begin(), outcomes.end(), Stage::left_over), 0);
}

TEST(TraceFile, ATestOfADistanceTakesTwoBytesAtMost) {
    for (const DistanceOrder order : {DistanceOrder::nearest, DistanceOrder::depth_first}) {
        const Trace trace = record_trace(
            soup_a(), soup_b(), asking_distance(VolumeKind::scb2, {.order = order}), {25}, -0.1);
        std::array<TraceNodes, 2> nodes;
        frame_bytes(trace.header, trace.frames[0], nodes);
        // The nodes are known by now.
        const Bytes plain = frame_bytes(trace.header, trace.frames[0], nodes);
        constexpr std::size_t pose_and_answer = 190;
        EXPECT_LT(plain.size(), 2 * trace.frames[0].found.n_v + pose_and_answer);
    }
}

TEST(TraceFile, ASceneNameThatIsNoFileNameIsRefused) {
    for (const char* name : {"../up", "a/b", "", ".hidden"}) {
        Trace trace = small_trace();
        trace.header.scene = name;
        EXPECT_THROW(decode_trace(encode_trace(trace), "t"), InputError) << name;
    }
}

TEST(TraceFile, EmptyTracesAndSingleTriangles) {
    Trace trace = small_trace();
    trace.frames.clear();
    expect_same(trace, decode_trace(encode_trace(trace), "file"));
    const BuiltMesh one(soup_mesh({1, 0.1, 0.5, 3}));
    Trace tiny = record_trace(one, one, asking(VolumeKind::scb, OverlapTest::extents), {0, 90});
    tiny.frames.push_back(record_frame(one, one, 91, Pose{}, tiny.header));
    EXPECT_EQ(tiny.frames[2].found.n_p, 1u);
    expect_same(tiny, decode_trace(encode_trace(tiny), "file"));
}

TEST(TraceFile, ATestTakesLessThanHalfAByte) {
    const Scene scene = load_scene({"spheres-l1"});
    const BuiltMesh a(scene.meshes[scene.bodies[0].mesh].mesh);
    const BuiltMesh b(scene.meshes[scene.bodies[1].mesh].mesh);
    const TraceHeader header = asking(VolumeKind::scb, OverlapTest::symmetric);
    Trace trace = record_trace(a, b, header, {});
    std::uint64_t tests = 0;
    for (int frame = 100; frame < 300; frame += 10) {
        trace.frames.push_back(record_frame(a, b, frame,
                                            relative_pose(pose_at(scene.bodies[0].motion, frame),
                                                          pose_at(scene.bodies[1].motion, frame)),
                                            header));
        tests += trace.frames.back().found.n_v;
    }
    const Bytes bytes = encode_trace(trace);
    const double per_test = static_cast<double>(bytes.size()) / static_cast<double>(tests);
    EXPECT_LT(per_test, 0.6);
    RecordProperty("bytes_per_test", std::to_string(per_test));
    expect_same(trace, decode_trace(bytes, "file"));
}

TEST(TraceFile, TracesThatRepeatThemselvesStayReadable) {
    // Every pair of leaves overlaps, so one byte follows another of its kind.
    Mesh mesh;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    mesh.triangles.assign(300, {0, 1, 2});
    const BuiltMesh same(mesh);
    Trace trace = record_trace(same, same, asking(VolumeKind::scb, {}), {});
    trace.frames.push_back(record_frame(same, same, 0, Pose{}, trace.header));
    EXPECT_EQ(trace.frames[0].found.pairs.size(), 90000u);
    const Bytes bytes = encode_trace(trace);
    EXPECT_LT(3 * bytes.size(), trace.frames[0].found.n_v);
    expect_same(trace, decode_trace(bytes, "file"));

    const Bytes zeros(1'000'000, 0), packed = pack(zeros);
    EXPECT_GT(most_unpacked * packed.size(), zeros.size());
    EXPECT_EQ(unpack(packed, zeros.size()), zeros);
    EXPECT_FALSE(unpack(packed, zeros.size() - 1));
    EXPECT_FALSE(unpack(packed, zeros.size() + 1));
}

}  // namespace
}  // namespace scb::scenes
