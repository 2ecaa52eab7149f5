#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/scenes/recordings/judged_recordings.h"

namespace scb::scenes {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr auto tests_apart = static_cast<std::uint8_t>(RecordTag::items_apart);

/// A mesh of two triangles at x = 0 and x = 3 at the height z, and its tree: the root is node 0,
/// its leaves are the nodes 1 and 2. Boxes reach `room` above and below.
std::vector<Record> two_triangles(std::uint32_t number, double z, double room) {
    const auto box = [z, room](double from, double to) {
        return RecordedVolume{RecordedKind::aabb, {from, 0, z - room, to, 1, z + room}};
    };
    return {RecordedMesh{number,
                         "",
                         8,
                         {0, 0, z, 1, 0, z, 0, 1, z, 3, 0, z, 4, 0, z, 3, 1, z},
                         {0, 1, 2, 3, 4, 5}},
            RecordedTree{number, number, "", {}},
            RecordedNode{number, 0, record_none, 0, "", {1, 2}, {}, box(0, 4)},
            RecordedNode{number, 1, 0, 0, "", {}, {0}, box(0, 1)},
            RecordedNode{number, 2, 0, 0, "", {}, {1}, box(3, 4)},
            RecordedBody{number, number, number == 0 ? "A" : "B"}};
}

/// Both bodies, 2 apart.
std::vector<Record> bodies(double room = 0) {
    std::vector<Record> records = two_triangles(0, 0, room);
    append(records, two_triangles(1, 2, room));
    return records;
}

struct Bound {
    std::uint32_t a, b;
    double bound;
};

/// Tests of volumes with their bounds.
std::vector<Record> bounds(const std::vector<Bound>& tests) {
    std::vector<Record> records;
    for (const Bound& test : tests)
        append(records, {recorded_length(test.bound), RecordedEvent{0, test.a, test.b}});
    return records;
}

std::vector<Record> measured(std::uint32_t a, std::uint32_t b, double distance) {
    return {recorded_length(distance), RecordedEvent{tests_apart, a, b}};
}

/// The tests of a depth-first search that finds triangles 0 and 0.
std::vector<Record> search() {
    std::vector<Record> records = bounds({{0, 0, 2}, {1, 0, 2}, {2, 0, 2}, {1, 1, 2}, {1, 2, 2.5}});
    append(records, measured(0, 0, 2));
    return records;
}

std::vector<Record> query(const RecordedMeasure& measure, const std::vector<Record>& events,
                          const std::vector<Record>& answer, bool complete = true,
                          double room = 0) {
    std::vector<Record> records = bodies(room);
    append(records, {RecordedQuery{0, 1}, measure});
    append(records, events);
    append(records, answer);
    append(records, {RecordedQueryEnd{complete, 0}, RecordedEnd{}});
    return records;
}

const RecordedMeasure nearest{1, infinity, 0}, within{2, 2.25, 0};

std::string problems(const RecordingJudgement& judged) {
    std::string all;
    for (const auto* groups :
         {&judged.test_problems, &judged.answers, &judged.missed, &judged.false_pairs})
        for (const ProblemGroup& group : *groups) all += group.what + "\n";
    return all;
}

RecordingJudgement judged(const RecordedMeasure& measure, const std::vector<Record>& events,
                          const std::vector<Record>& answer, bool complete = true) {
    return judge(query(measure, events, answer, complete));
}

TEST(JudgedDistances, AreValidInAHealthyEngine) {
    const RecordingJudgement found = judged(nearest, search(), {RecordedAnswer{2, 0, 0, {}}});
    EXPECT_EQ(problems(found), "");
    EXPECT_EQ(found.verdict(), Verdict::valid) << not_judged(found);
    EXPECT_EQ(found.distances, 1u);
}

TEST(JudgedDistances, AreWrongIfTheyAreOthers) {
    EXPECT_EQ(problems(judged(nearest, search(), {RecordedAnswer{2.5, 0, 0, {}}})),
              "the distance is too large\nmeasured, but not reported\n");
    EXPECT_EQ(problems(judged(nearest, search(), {RecordedAnswer{1.5, 0, 0, {}}})),
              "the distance is too small\n");
}

TEST(JudgedDistances, NeedNotBeTheSmallestIfTheQueryEndedEarly) {
    const double far = std::sqrt(8.0);  // of triangles 0 and 1
    std::vector<Record> events = bounds({{0, 0, 2}, {0, 2, 2}, {1, 2, 2.5}});
    append(events, measured(0, 1, far));
    EXPECT_EQ(problems(judged(nearest, events, {RecordedAnswer{far, 0, 1, {}}}, false)), "");
    EXPECT_EQ(problems(judged(nearest, bounds({{0, 0, 2}}), {}, false)), "");
    EXPECT_NE(problems(judged(nearest, events, {RecordedAnswer{far, 0, 1, {}}})), "");
}

TEST(JudgedDistances, MayHaveTheErrorAndTheLimitThatWereAsked) {
    const auto found = [](const RecordedMeasure& measure, const std::vector<Record>& answer) {
        // The setting says that a query without a distance found none.
        std::vector<Record> records = {RecordedSetting{"results", "pairs"}};
        append(records, query(measure, bounds({{0, 0, 2}}), answer));
        return problems(judge(records));
    };
    EXPECT_EQ(found({1, 2.1, 0.1}, {}), "");
    EXPECT_EQ(found({1, 1.5, 0}, {}), "");
    EXPECT_EQ(found({1, 1.5, 0}, {RecordedAnswer{-1, 0, 0, {}}}), "");
    EXPECT_NE(found({1, 2.1, 0}, {}), "");
}

TEST(JudgedDistances, LeaveOutAnythingOnceTrianglesMeet) {
    std::vector<Record> records = two_triangles(0, 0, 0.25);
    append(records, two_triangles(1, 0, 0.25));
    append(records, {RecordedQuery{0, 1}, nearest});
    append(records, bounds({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 2, 2}}));
    append(records, measured(0, 0, 0));
    append(records, {RecordedAnswer{0, 0, 0, {}}, RecordedQueryEnd{}, RecordedEnd{}});
    const RecordingJudgement judgement = judge(records);
    EXPECT_EQ(problems(judgement), "");
    EXPECT_EQ(judgement.verdict(), Verdict::valid) << not_judged(judgement);
}

TEST(JudgedDistances, NameNodesThatWereLeftOut) {
    const std::vector<Record> answer = {RecordedAnswer{2, 0, 0, {}}};
    // The pair (2, 0) holds triangles 1 and 1, which are 2 apart, too.
    EXPECT_EQ(problems(judged(nearest, search(), answer)), "");
    // The boxes of the leaves (1, 1) are 1.5 apart, and lead to no test of triangles.
    const double far = std::sqrt(8.0);
    std::vector<Record> events =
        bounds({{0, 0, 1.5}, {1, 0, 1.5}, {2, 0, 1.5}, {1, 1, 1.5}, {1, 2, 2}});
    append(events, measured(0, 1, far));
    const std::vector<Record> records =
        query(nearest, events, {RecordedAnswer{far, 0, 1, {}}}, true, 0.25);
    EXPECT_EQ(problems(judge(records)),
              "nodes were left out although their bound is below the answer\n"
              "the distance is too large\nleft out although the volumes are nearer\n");
}

TEST(JudgedDistances, TakeRepeatedTestsAsOne) {
    // Each pair is tested when it is pushed, and again when it is popped.
    std::vector<Record> events =
        bounds({{0, 0, 1}, {0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {1, 0, 1}, {1, 1, 1}, {1, 2, 2}});
    append(events, bounds({{1, 1, 1}}));
    append(events, measured(0, 0, 2));
    append(events, bounds({{2, 0, 1}}));
    append(events, bounds({{2, 1, 2}, {2, 2, 1}, {2, 2, 1}}));
    append(events, measured(1, 1, 2));
    const std::vector<Record> answer = {RecordedAnswer{2, 0, 0, {}}};
    EXPECT_EQ(problems(judge(query(nearest, events, answer, true, 0.25))), "");
}

TEST(JudgedDistances, TakeTestsThatGaveUp) {
    const auto found = [](double distance) {
        std::vector<Record> events =
            bounds({{0, 0, 1}, {1, 0, 2}, {2, 0, infinity}, {1, 1, 2}, {1, 2, 2}});
        append(events, measured(0, 0, 2));
        append(events, measured(0, 1, distance));
        return problems(judged(nearest, events, {RecordedAnswer{2, 0, 0, {}}}));
    };
    EXPECT_EQ(found(infinity), "");
    EXPECT_EQ(found(std::numeric_limits<double>::quiet_NaN()),
              "a measured distance of two triangles is wrong\n");
}

TEST(JudgedDistances, NameABoundThatIsTooLarge) {
    std::vector<Record> events = bounds({{0, 0, 2}, {1, 0, 2}, {2, 0, 2}, {1, 1, 2}, {1, 2, 2.9}});
    append(events, measured(0, 0, 2));
    EXPECT_EQ(problems(judged(nearest, events, {RecordedAnswer{2, 0, 0, {}}})),
              "a bound that is larger than the distance of the volumes\n")
        << "the boxes of (1, 2) are the root of 8 apart";
}

TEST(JudgedDistances, CompareTestsOfTrianglesWithTheTolerance) {
    const auto events = [](bool meet) {
        std::vector<Record> all =
            bounds({{0, 0, 2}, {1, 0, 2}, {2, 0, 2}, {1, 1, 2}, {2, 2, 2}, {1, 2, 2}});
        append(all, {RecordedEvent{items_meet, 0, 0}, RecordedEvent{items_meet, 1, 1},
                     RecordedEvent{meet ? items_meet : items_apart, 0, 1}});
        return all;
    };
    const std::vector<Record> pairs = {RecordedEvent{a_pair, 0, 0}, RecordedEvent{a_pair, 1, 1}};
    EXPECT_EQ(problems(judged(within, events(false), pairs)), "");
    EXPECT_EQ(problems(judged(within, events(true), pairs)),
              "a test of two triangles is wrong about whether they are within the tolerance\n");
}

TEST(JudgedDistances, AreNotJudgedIfTheyAreNotKnown) {
    const auto why = [](const std::vector<Record>& records) {
        const RecordingJudgement found = judge(records);
        EXPECT_EQ(problems(found), "");
        EXPECT_EQ(found.verdict(), Verdict::partly_judged);
        return not_judged(found);
    };
    // No distance, anywhere.
    EXPECT_NE(why(query(nearest, search(), {})).find("no distances were recorded"),
              std::string::npos);
    // A kind, or a limit, of a later version.
    for (const RecordedMeasure& unknown :
         {RecordedMeasure{7, 1, 0}, RecordedMeasure{1, -1, 0}, RecordedMeasure{2, infinity, 0}})
        EXPECT_NE(why(query(unknown, search(), {})).find("unknown kind"), std::string::npos);
    // A body to itself.
    std::vector<Record> records = bodies();
    append(records, {RecordedQuery{0, 0}, nearest});
    append(records, bounds({{1, 2, 2}}));
    append(records, {RecordedAnswer{777, 0, 1, {}}, RecordedQueryEnd{}});
    EXPECT_NE(why(records).find("1 queries of distances: they are of objects, or of a body"),
              std::string::npos);
    // Objects.
    records = two_balls();
    append(records, {RecordedQuery{0, 1}, nearest});
    append(records, {RecordedAnswer{777, 0, 0, {}}, RecordedQueryEnd{}});
    EXPECT_NE(why(records).find("1 queries of distances: they are of objects, or of a body"),
              std::string::npos);
}

TEST(JudgedDistances, NameTheDistanceOfAnEarlierFrame) {
    std::vector<Record> records = bodies();
    append(records, {RecordedFrame{0}, RecordedQuery{0, 1}, nearest, RecordedAnswer{2, 0, 0, {}},
                     RecordedQueryEnd{}, RecordedFrame{1},
                     RecordedPose{1, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1}}, RecordedQuery{0, 1},
                     nearest, RecordedAnswer{2, 0, 0, {}}, RecordedQueryEnd{}});
    const RecordingJudgement found = judge(records);
    ASSERT_EQ(found.answers.size(), 1u);
    EXPECT_NE(found.answers[0].cases[0].words.find("the distance of an earlier frame"),
              std::string::npos)
        << found.answers[0].cases[0].words;
}

}  // namespace
}  // namespace scb::scenes
