#include "scenes/recordings/recorded_queries.h"

#include <gtest/gtest.h>

#include "tests/scenes/recordings/read_steps.h"
#include "tests/scenes/recordings/small_records.h"

namespace scb::scenes {
namespace {

TEST(RecordedQueries, SumsUpAllThatThereIs) {
    std::vector<Record> records = two_balls();
    append(records, {RecordedFrame{2}});
    append(records, query_with({{0, 0, 0},
                                {1, 0, 0},
                                {127, 0, 0},
                                {128, 0, 0},
                                {129, 0, 0},
                                {130, 0, 0},
                                {131, 0, 0},
                                {191, 0, 0}}));
    append(records, {RecordedFrame{5}});
    append(records, query_with({{127, 0, 0}}));
    const RecordingSummary summary = summary_of(RecordingBytes(recording_of(records)), "x.scbrec");
    EXPECT_EQ(summary.frames, (std::vector{2, 5}));
    EXPECT_EQ(summary.stages, (std::set<std::uint8_t>{1, 127}));
    EXPECT_EQ(summary.queries, 2u);
    EXPECT_EQ(summary.volume_tests, 4u);
    EXPECT_EQ(summary.item_tests, 2u);
    EXPECT_EQ(summary.pairs, 1u);
    EXPECT_FALSE(summary.has_pairs);
    EXPECT_EQ(summary_of(RecordingBytes(recording_of({})), "x.scbrec").frames, std::vector{0});
}

TEST(RecordedQueries, KeepsTheParentsOfTestsThatAreValid) {
    constexpr auto parent = static_cast<std::uint8_t>(RecordTag::parent);
    std::vector<Record> records;
    for (const std::uint32_t tree : {0u, 1u}) {
        records.emplace_back(RecordedTree{tree, record_none, "", {}});
        records.emplace_back(RecordedNode{tree, 0, record_none, 0, "", {1, 2}, {}, ball_volume(1)});
        for (const std::uint32_t leaf : {1u, 2u})
            records.emplace_back(RecordedNode{tree, leaf, 0, 0, "", {}, {leaf}, ball_volume(1)});
        records.emplace_back(RecordedBody{tree, tree, ""});
    }
    append(records, query_with({{0, 0, 0},
                                {parent, 0, 0},
                                {128, 5, 5},
                                {0, 1, 0},
                                {parent, 1, 0},
                                {1, 1, 2},
                                {0, 2, 0},
                                {parent, 5, 0},
                                {1, 2, 1},
                                {parent, 1, 0},
                                {1, 2, 2},
                                {parent, 0, 0},
                                {1, 0, 0},
                                {parent, 2, 0}}));
    append(records, query_with({{0, 0, 0}}));
    ReadSteps read(records);
    std::vector<std::uint32_t> parents;
    for (const EngineEvent& event : read.query(0).events)
        if (event.kind == EngineEvent::Kind::volumes) parents.push_back(event.parent);
    EXPECT_EQ(parents,
              (std::vector<std::uint32_t>{no_index, 0, 1, no_index, no_index, no_index, no_index}));
    EXPECT_EQ(read.query(0).events.at(0).parent, no_index) << "a parent is of one query";
    const OddRecords& unusable = read.queries.unusable();
    EXPECT_EQ(unusable.count, 3u);
    EXPECT_EQ(unusable.first,
              (std::vector<std::string>{
                  "test 4 of a query has the parent 5, which is no earlier test, at frame 0",
                  "test 5 of a query has the parent 1, whose nodes are not above its nodes, at "
                  "frame 0",
                  "test 6 of a query has the parent 0, whose nodes are not above its nodes, at "
                  "frame 0"}));
}

TEST(RecordedQueries, TellsPairsWhereTheSettingOrAPairSaysSo) {
    const auto tells = [](const std::vector<Record>& before, std::uint8_t tag) {
        std::vector<Record> records = before;
        append(records, two_balls());
        append(records, query_with({{tag, 0, 0}}));
        return ReadSteps(records).query(0).has_pairs;
    };
    constexpr auto a_test = static_cast<std::uint8_t>(RecordTag::volumes_overlap),
                   one_pair = static_cast<std::uint8_t>(RecordTag::pair);
    EXPECT_FALSE(tells({}, a_test));
    EXPECT_TRUE(tells({}, one_pair));
    EXPECT_TRUE(tells({RecordedSetting{"results", "pairs"}}, a_test));
    EXPECT_FALSE(tells({RecordedSetting{"results", "none"}}, a_test));
}

TEST(RecordedQueries, AQueryThatTheFileBreaksOffInIsNotComplete) {
    std::vector<Record> records = two_balls();
    append(records, {RecordedQuery{0, 1}, RecordedEvent{0, 0, 0}});
    ReadSteps read(records);
    EXPECT_FALSE(read.query(0).complete);
    EXPECT_EQ(read.queries.query().events.size(), 1u);
    EXPECT_EQ(read.queries.next(), RecordedQueries::Ended::frame);
    EXPECT_EQ(read.queries.next(), RecordedQueries::Ended::end);
}

TEST(RecordedQueries, MakesAPoseOf32BitsRigid) {
    const auto recorded_pose = [](const std::array<double, 12>& rows) {
        std::vector<Record> records = two_balls();
        records.emplace_back(RecordedPose{1, rows});
        ReadSteps read(records);
        read.read_all();
        return read.queries.bodies().at(1);
    };
    // A turn about all axes whose numbers are rounded to float.
    const std::array<double, 12> exact = {0.36, 0.48, -0.8, 7, -0.8, 0.6, 0, 8, 0.48, 0.64, 0.6, 9};
    std::array<double, 12> rounded = exact;
    for (double& number : rounded) number = static_cast<double>(static_cast<float>(number));
    const BodyState body = recorded_pose(rounded);
    EXPECT_FALSE(body.is_stretched());
    EXPECT_GT(body.defect, 1e-9);
    EXPECT_LT(rigidity_defect(body.pose), 1e-15);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(body.pose.rotation(i, j), exact[static_cast<std::size_t>(4 * i + j)], 1e-7);
    EXPECT_EQ(body.pose.translation, Vec3(7, 8, 9));
    // One of 64 bits stays as it is, and one that is scaled too.
    std::array<double, 12> nearly = exact;
    nearly[0] += 1e-13;
    EXPECT_EQ(recorded_pose(nearly).pose.rotation(0, 0), nearly[0]);
    nearly = exact;
    nearly[3] = 1e71;
    EXPECT_EQ(recorded_pose(nearly).pose_fault, "is beyond 1e70");
}

// A vertex that is not finite must not hide an index of a missing vertex.
TEST(RecordedQueries, RefusesAnIndexBeyondTheVerticesOfATriangleThatIsNotFinite) {
    ReadSteps read(
        std::vector<Record>{RecordedMesh{0, "", 8, {NAN, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 99}}});
    EXPECT_THROW(read.read_all(), InputError);
}

/// The body of a pose with these columns.
BodyState body_with(const std::array<double, 9>& columns) {
    std::vector<Record> records = two_balls();
    RecordedPose pose = pose_at(1, 5);
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            pose.rows[4 * row + column] = columns[3 * column + row];
    records.emplace_back(pose);
    ReadSteps read(records);
    read.read_all();
    return read.queries.bodies().at(1);
}

TEST(RecordedQueries, APoseMayStretchItsBody) {
    const BodyState scaled = body_with({0, 2, 0, -2, 0, 0, 0, 0, 2});
    EXPECT_EQ(scaled.stretch, Mat3(2 * Mat3::Identity()));
    EXPECT_LT(rigidity_defect(scaled.pose), 1e-15);
    EXPECT_EQ(stretch_words(scaled.stretch), "scaled by 2");
    const BodyState mirrored = body_with({-1, 0, 0, 0, 1, 0, 0, 0, 1});
    EXPECT_LT(rigidity_defect(mirrored.pose), 1e-15);
    EXPECT_EQ(stretch_words(mirrored.stretch), "mirrored");
    EXPECT_EQ(stretch_words(body_with({1, 0, 0, 0, 2, 0, 0, 0, 3}).stretch),
              "scaled by 1, 2 and 3");
    EXPECT_EQ(stretch_words(body_with({-2, 0, 0, 0, 2, 0, 0, 0, 2}).stretch),
              "scaled by 2 and mirrored");
    const BodyState sheared = body_with({1, 0, 0, 1, 1, 0, 0, 0, 1});
    EXPECT_EQ(stretch_words(sheared.stretch), "sheared");
    EXPECT_EQ(sheared.pose.rotation, Mat3::Identity());
    EXPECT_EQ(sheared.pose.translation, Vec3(5, 0, 0));
    EXPECT_EQ(body_with({1, 0, 0, 0, 1, 0, 1, 1, 0}).pose_fault, "makes the body flat");
    EXPECT_EQ(body_with({NAN, 0, 0, 0, 1, 0, 0, 0, 1}).pose_fault, "is not finite");
    Pose far;
    far.translation[0] = 1e71;
    EXPECT_TRUE(body_pose(far).is_finite);
    EXPECT_EQ(body_pose(far).pose_fault, "is beyond 1e70");
    EXPECT_EQ(body_with({0, 0, 0, 0, 0, 0, 0, 0, 0}).pose_fault, "makes the body flat");
}

TEST(RecordedQueries, AQueryHasThePosesOfBothBodies) {
    for (const std::uint32_t flat : {0u, 1u}) {
        std::vector<Record> records = two_balls();
        RecordedPose pose = pose_at(flat, 1);
        pose.rows[0] = 0;
        records.emplace_back(pose);
        append(records, query_with({}));
        EXPECT_FALSE(ReadSteps(records).query(0).placed);
    }
}

TEST(RecordedQueries, ABodyThatIsToldAgainStaysWhereItIs) {
    std::vector<Record> records = two_balls();
    append(records, {pose_at(1, 5), RecordedBody{1, 1, "B"}});
    append(records, query_with({}));
    ReadSteps read(records);
    EXPECT_EQ(read.query(0).b_to_a.translation, Vec3(5, 0, 0));
    EXPECT_TRUE(read.queries.bodies().at(1).placed);
}

/// A triangle that reaches 10 from the origin, in coordinates of so many bytes.
RecordedMesh mesh_of_ten(std::uint8_t coordinate_bytes) {
    return {0, "", coordinate_bytes, {-10, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}};
}

/// The tolerance of a tree of that mesh, or of none, whose only node has this volume.
double tolerance_of(const std::vector<Record>& before, const RecordedVolume& volume) {
    std::vector<Record> records = before;
    append(records, body_of_one_node(0, volume));
    for (Record& record : records)
        if (auto* tree = std::get_if<RecordedTree>(&record); tree && !before.empty())
            if (std::holds_alternative<RecordedMesh>(before.back())) tree->mesh = 0;
    ReadSteps read(records);
    read.read_all();
    return read.queries.tolerance_of(read.queries.trees().at(0));
}

TEST(RecordedQueries, TakesTheToleranceFromTheExactnessOfTheNumbers) {
    constexpr double single = 1e-6, exact = 1e-12;
    EXPECT_DOUBLE_EQ(tolerance_of({}, ball_volume(4)), 4 * single);
    EXPECT_DOUBLE_EQ(tolerance_of({}, ball_volume(4, 0.1)), 4 * exact);
    EXPECT_DOUBLE_EQ(tolerance_of({}, ball_volume(4, -8)), 8 * single);
    EXPECT_DOUBLE_EQ(tolerance_of({mesh_of_ten(4)}, ball_volume(4, 0.1)), 10 * single);
    EXPECT_DOUBLE_EQ(tolerance_of({mesh_of_ten(8)}, ball_volume(4, 0.1)), 10 * exact);
    EXPECT_DOUBLE_EQ(tolerance_of({mesh_of_ten(8)}, ball_volume(4)), 10 * exact)
        << "whole numbers say nothing";
    EXPECT_DOUBLE_EQ(tolerance_of({mesh_of_ten(8)}, ball_volume(4, static_cast<double>(0.1f))),
                     10 * single);
    EXPECT_DOUBLE_EQ(tolerance_of({mesh_of_ten(8)}, {}), 10 * exact) << "no volume";
}

TEST(RecordedQueries, TakesTheToleranceThatIsTold) {
    const auto told = [](const std::string& value) {
        return tolerance_of({RecordedSetting{"tolerance", value}}, ball_volume(4));
    };
    EXPECT_EQ(told("0.25"), 0.25);
    EXPECT_EQ(told("0"), 4e-12) << "this program's own rounding";
}

TEST(RecordedQueries, TheToleranceOfAQueryIsThatOfAllItsLengths) {
    for (const std::uint32_t first : {0u, 1u}) {
        std::vector<Record> records = body_of_one_node(0, ball_volume(4, 0.1));
        append(records, body_of_one_node(1, ball_volume(2)));
        RecordedPose skew = pose_at(0, 3);
        skew.rows[1] = 1e-5;
        append(records, {skew, RecordedQuery{first, 1 - first}, RecordedQueryEnd{}});
        // B's numbers are of 32 bits, and A's pose is a little off.
        EXPECT_NEAR(ReadSteps(records).query(0).tolerance,
                    (4 + 2 + 3 / 8.0) * 1e-6 + (4 + 2 + 3) * 1e-5, 1e-12);
    }
}

TEST(RecordedQueries, AToleranceThatIsNoLengthIsUnusable) {
    for (const char* value : {"", "x", "1e-6 m", " 1", "-1e-6", "1e200", "nan", "inf"}) {
        ReadSteps read(std::vector<Record>{RecordedSetting{"tolerance", value}});
        read.read_all();
        EXPECT_EQ(read.queries.unusable().count, 1u) << value;
    }
}

TEST(RecordedQueries, NamesStagesOneTo127InTheOrderInWhichTheyAreTold) {
    ReadSteps read(std::vector<Record>{RecordedStage{127, "last"}, RecordedStage{1, "x"},
                                       RecordedStage{0, "none"}, RecordedStage{128, "none"},
                                       RecordedStage{1, "first"}});
    read.read_all();
    EXPECT_EQ(read.queries.stages(),
              (std::map<std::uint8_t, std::string>{{1, "first"}, {127, "last"}}));
    EXPECT_EQ(read.queries.stage_order(), (std::vector<std::uint8_t>{127, 1}));
    EXPECT_EQ(read.queries.unusable().count, 2u);
}

TEST(RecordedQueries, CountsUnusableRecordsBeyondTheFirstTwenty) {
    ReadSteps read(std::vector<Record>(23, RecordedStage{0, ""}));
    read.read_all();
    EXPECT_EQ(read.queries.unusable().first.size(), 20u);
    EXPECT_EQ(read.queries.unusable().count, 23u);
}

TEST(RecordedQueries, AMeshThatIsToldAgainAlikeDidNotChange) {
    std::vector<Record> records = {mesh_of_ten(8), RecordedTree{0, 0, "", {}}};
    const auto versions = [&] {
        ReadSteps read(records);
        read.read_all();
        return std::pair(read.queries.meshes().at(0).version,
                         read.queries.trees().at(0).volume_version);
    };
    const auto before = versions();
    records.emplace_back(mesh_of_ten(8));
    EXPECT_EQ(versions(), before);
    RecordedMesh moved = mesh_of_ten(8);
    moved.coordinates[8] = 1;
    records.emplace_back(moved);
    EXPECT_GT(versions().first, before.first);
    EXPECT_GT(versions().second, before.second);
}

TEST(RecordedQueries, JudgesObjectsByTheirVolumesWhereEachIsAloneInALeaf) {
    const auto side = [](const std::vector<std::uint32_t>& of_root,
                         const std::vector<std::uint32_t>& of_leaf) {
        ReadSteps read(std::vector<Record>{RecordedTree{0, record_none, "", {}},
                                           RecordedNode{0, 0, record_none, 0, "", {1}, of_root, {}},
                                           RecordedNode{0, 1, 0, 0, "", {}, of_leaf, {}}});
        read.read_all();
        const EngineSide told = read.queries.side_of(0);
        return std::pair(told.objects_by_volume, told.shape->holder.size());
    };
    EXPECT_EQ(side({}, {7}), std::pair(true, std::size_t{8}));
    EXPECT_EQ(side({}, {7, 3}), std::pair(false, std::size_t{8}));
    EXPECT_EQ(side({2}, {7}), std::pair(false, std::size_t{8}));
    EXPECT_EQ(side({}, {}), std::pair(false, std::size_t{0}));
    EXPECT_EQ(side({}, {UINT32_MAX}), std::pair(false, std::size_t{0})) << "no number of objects";
}

TEST(RecordedQueries, RefusesFramesBeyondWholeNumbers) {
    constexpr std::uint32_t most = INT32_MAX;
    ReadSteps(std::vector<Record>{RecordedFrame{most - 1}}).read_all();
    EXPECT_THROW(ReadSteps(std::vector<Record>{RecordedFrame{most}}).read_all(), InputError);
}

TEST(RecordedQueries, TheLastSettingOfExactTestsHolds) {
    ReadSteps read(std::vector<Record>{RecordedSetting{"tests", "exact"},
                                       RecordedSetting{"tests", "conservative"}});
    read.read_all();
    EXPECT_FALSE(read.queries.has_exact_tests());
}

TEST(RecordedQueries, ABodyThatGetsAnotherTreeIsStretchedAnew) {
    std::vector<Record> records = two_balls();
    RecordedPose twice = pose_at(1, 0);
    for (const std::size_t i : {0u, 5u, 10u}) twice.rows[i] = 2;
    append(records,
           {twice, RecordedQuery{0, 1}, RecordedQueryEnd{}, RecordedTree{2, record_none, "", {}},
            RecordedNode{2, 7, record_none, 0, "", {}, {0}, ball_volume(3)},
            RecordedBody{1, 2, "B"}, RecordedQuery{0, 1}, RecordedQueryEnd{}});
    ReadSteps read(records);
    EXPECT_EQ((*read.query(0).sides[1].tree)[0].number, 0u);
    const EngineQuery& second = read.query(0);
    EXPECT_EQ((*second.sides[1].tree)[0].number, 7u);
    EXPECT_EQ(std::get<Ball>((*second.sides[1].tree)[0].volume).radius, 6);
}

}  // namespace
}  // namespace scb::scenes
