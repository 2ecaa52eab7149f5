#include "core/analysis/attribution.h"

#include <gtest/gtest.h>

#include "core/analysis/inspection.h"
#include "tests/core/analysis/made_query.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

constexpr std::uint32_t none = MadeQuery::none;

TestedPair pair_of(Contact exact, std::uint64_t contacts = 0, double gap = 0) {
    TestedPair pair;
    pair.exact = exact;
    pair.contacts = contacts;
    pair.gap = gap;
    return pair;
}
const TestedPair meeting = pair_of(Contact::overlapping, 1), loose = pair_of(Contact::overlapping),
                 weak = pair_of(Contact::disjoint, 0, 0.5);

/// 0 led to 1 and 2, 1 to 3 and 4, 3 to 5, and that to a test of triangles.
MadeQuery some_query() {
    MadeQuery query;
    query.test(none, {0, 0});
    query.test(0, {1, 0});
    query.test(0, {2, 0}, false);
    query.test(1, {3, 0});
    query.test(1, {4, 0}, false);
    query.test(3, {5, 0});
    query.triangles({0, 0}, false);
    return query;
}

Attribution attributed(const MadeQuery& query, const std::vector<TestedPair>& pairs) {
    return attribute(query.header, query.frame, pairs);
}

TEST(Attribution, SaysWhyEachPairPassedAndWhatCameOfIt) {
    TestedPair touching = pair_of(Contact::touching);
    touching.leaves = true;
    const Attribution found =
        attributed(some_query(), {meeting, weak, loose, loose, weak, touching});
    ASSERT_EQ(found.passed.size(), 4u);
    const PassedPair &roots = found.passed[0], &first = found.passed[1], &second = found.passed[2],
                     &leaves = found.passed[3];
    EXPECT_EQ(roots.reason, PassReason::triangles_meet);
    EXPECT_EQ(roots.below, (Work{5, 1, 0}));
    EXPECT_EQ(first.reason, PassReason::weak_test);
    EXPECT_EQ(first.gap, 0.5);
    EXPECT_EQ(first.below, (Work{3, 1, 0}));
    EXPECT_EQ(first.within, PassReason::triangles_meet);
    EXPECT_EQ(second.reason, PassReason::loose_fit);
    EXPECT_EQ(second.gap, 0);
    EXPECT_EQ(second.within, PassReason::weak_test);
    EXPECT_EQ(leaves.within, PassReason::weak_test) << "at any distance";
    EXPECT_EQ(leaves.below, (Work{0, 1, 0}));
    ASSERT_EQ(found.wrongly_rejected.size(), 1u);
    EXPECT_EQ(found.wrongly_rejected[0], (WrongRejection{2, 0, Contact::overlapping}));
    const PassCounts& counts = found.counts;
    EXPECT_EQ(counts.all, (Work{6, 1, 0}));
    EXPECT_EQ(counts.wasted(), (Work{3, 1, 0}));
    EXPECT_EQ(counts.wasted_by(PassReason::weak_test), (Work{3, 1, 0}));
    EXPECT_EQ(counts.wasted_by(PassReason::loose_fit), Work{});
    EXPECT_EQ(counts.touching, 1u);
    EXPECT_EQ(counts.wrongly_rejected, 1u);
    EXPECT_EQ(counts.missed, 0u);
    EXPECT_EQ(counts.inner, (std::array<std::uint64_t, 5>{1, 1, 1, 0, 0}));
    EXPECT_EQ(counts.leaves, (std::array<std::uint64_t, 5>{0, 1, 0, 0, 0}));
    EXPECT_EQ(counts.passed(PassReason::loose_fit), 2u);
    EXPECT_EQ(counts.passed(), 4u);
}

TEST(Attribution, WorkBelowAFalsePairIsWastedOnce) {
    // Weak within loose: an exact test would save what is below the weak one alone.
    const PassCounts counts =
        attributed(some_query(), {loose, loose, weak, weak, weak, weak}).counts;
    EXPECT_EQ(counts.wasted(), (Work{5, 1, 0}));
    EXPECT_EQ(counts.wasted_by(PassReason::weak_test), (Work{1, 1, 0}));
    EXPECT_EQ(counts.wasted_by(PassReason::loose_fit), (Work{4, 0, 0}));
}

TEST(Attribution, OfDistancesTakesTheReasonThatIsCuredMostEasily) {
    MadeQuery query;
    query.header.kind = QueryKind::distance;
    query.test(MadeQuery::none, {0, 0});
    for (std::uint32_t i = 0; i < 5; ++i) query.test(i, {i + 1, i + 1});
    query.triangles({0, 0}, false);
    const TestedPair open = pair_of(Contact::touching);
    TestedPair early = weak;
    early.early = true;
    // Each pair leads to the next, and the last one to the test of triangles.
    const Attribution found = attributed(query, {meeting, loose, open, weak, early, loose});
    const auto reasons_are = [&](const std::vector<PassReason>& reasons) {
        for (std::size_t i = 0; i < reasons.size(); ++i)
            EXPECT_EQ(found.passed[i].reason, reasons[i]) << i;
    };
    reasons_are({PassReason::triangles_meet, PassReason::loose_fit, PassReason::unjudged,
                 PassReason::weak_test, PassReason::early, PassReason::loose_fit});
    EXPECT_EQ(found.passed[3].gap, 0.5);
    EXPECT_EQ(found.passed[4].gap, 0.5);
    EXPECT_EQ(found.wasted_by,
              (std::vector<PassReason>{PassReason::triangles_meet, PassReason::triangles_meet,
                                       PassReason::loose_fit, PassReason::unjudged,
                                       PassReason::weak_test, PassReason::early}));
    const PassCounts& counts = found.counts;
    EXPECT_EQ(counts.wasted(), (Work{4, 1}));
    EXPECT_EQ(counts.wasted_by(PassReason::loose_fit), (Work{1, 0}));
    EXPECT_EQ(counts.wasted_by(PassReason::unjudged), (Work{1, 0}));
    EXPECT_EQ(counts.wasted_by(PassReason::weak_test), (Work{1, 0}));
    EXPECT_EQ(counts.wasted_by(PassReason::early), (Work{1, 1}));
    EXPECT_EQ(counts.wasted_by(PassReason::triangles_meet), Work{});
    // All tests below an early pair are wasted by it.
    const PassCounts around = attributed(query, {meeting, early, weak, loose, open, loose}).counts;
    EXPECT_EQ(around.wasted_by(PassReason::early), around.wasted());
    EXPECT_EQ(around.wasted(), (Work{4, 1}));
    const Inspection by_depth = inspection(query.frame, found);
    for (const PassReason reason : waste_reasons(QueryKind::distance)) {
        std::uint64_t sum = 0;
        for (const DepthInspection& depth : by_depth.depths) sum += depth.wasted.by(reason);
        EXPECT_EQ(sum, counts.wasted_by(reason).volume_tests);
    }
}

TEST(Attribution, ARejectionIsWrongWhereVolumesOverlapOrTrianglesMeet) {
    const TestedPair touching = pair_of(Contact::touching), lost = pair_of(Contact::disjoint, 3);
    const auto wrong = [](const TestedPair& second, const TestedPair& fourth) {
        const Attribution found =
            attributed(some_query(), {meeting, meeting, second, meeting, fourth, meeting});
        EXPECT_EQ(found.counts.wrongly_rejected, found.wrongly_rejected.size());
        return found;
    };
    EXPECT_EQ(wrong(weak, touching).wrongly_rejected, std::vector<WrongRejection>{});
    EXPECT_EQ(wrong(lost, touching).wrongly_rejected,
              (std::vector<WrongRejection>{{2, 3, Contact::disjoint}}));
    EXPECT_EQ(wrong(lost, meeting).counts.missed, 4u);
    EXPECT_EQ(wrong(loose, loose).wrongly_rejected.size(), 2u);
}

TEST(Attribution, NothingIsClaimedOfAPairThatIsNotKnown) {
    TestedPair unknown = loose;
    unknown.known = false;
    const Attribution found =
        attributed(some_query(), {meeting, unknown, unknown, loose, unknown, loose});
    ASSERT_EQ(found.passed.size(), 3u);
    EXPECT_EQ(found.passed[1].test, 3u);
    EXPECT_EQ(found.passed[1].within, PassReason::triangles_meet)
        << "it is the outermost that is known";
    EXPECT_EQ(found.counts.wasted(), (Work{1, 1, 0}));
    EXPECT_TRUE(found.wrongly_rejected.empty());
}

TEST(Attribution, OfASelfQueryFindsTheContactsBelowEachTest) {
    const BuiltMesh body(random_soup(17, 60, 0.4));
    const TraceHeader header = asking_self(VolumeKind::scb);
    const QueryTrace frame = record_frame(body, body, 0, Pose{}, header);
    const AnyHierarchy& hierarchy = body.hierarchies[static_cast<std::size_t>(header.volume)];
    const std::vector<IndexPair>& contacts = frame.found.pairs;
    const Attribution found = attribute(hierarchy, hierarchy, header, frame, contacts);

    const Topology& topology = topology_of(hierarchy);
    const auto holds = [&](std::uint32_t node, std::uint32_t triangle) {
        const TopologyNode& of = topology.nodes[node];
        const auto first = topology.order.begin() + of.first;
        return std::find(first, first + of.count, triangle) != first + of.count;
    };
    std::size_t met = 0;
    for (const PassedPair& pair : found.passed) {
        const IndexPair nodes = frame.steps.volumes[pair.test].nodes;
        const bool meets = std::any_of(contacts.begin(), contacts.end(), [&](IndexPair c) {
            return (holds(nodes.a, c.a) && holds(nodes.b, c.b)) ||
                   (holds(nodes.a, c.b) && holds(nodes.b, c.a));
        });
        EXPECT_EQ(pair.reason == PassReason::triangles_meet, meets) << pair.test;
        met += meets;
    }
    EXPECT_GT(met, contacts.size());
    EXPECT_LT(met, found.passed.size());
    EXPECT_TRUE(found.wrongly_rejected.empty());
}

TEST(PassCounts, AddUpMemberByMember) {
    const TestedPair touching = pair_of(Contact::touching);
    PassCounts one =
        attributed(some_query(), {meeting, weak, meeting, loose, weak, touching}).counts;
    one += attributed(some_query(), {meeting, loose, meeting, loose, weak, touching}).counts;
    PassCounts two = one;
    two += one;
    EXPECT_EQ(two.missed, 2 * one.missed);
    EXPECT_EQ(two.touching, 2 * one.touching);
    EXPECT_EQ(two.wrongly_rejected, 2 * one.wrongly_rejected);
    EXPECT_EQ(two.passed(), 2 * one.passed());
    const auto expect_twice = [](const Work& doubled, const Work& work) {
        EXPECT_GT(work.volume_tests + work.triangle_tests, 0u);
        EXPECT_EQ(doubled.volume_tests, 2 * work.volume_tests);
        EXPECT_EQ(doubled.triangle_tests, 2 * work.triangle_tests);
    };
    expect_twice(two.all, one.all);
    expect_twice(two.wasted(), one.wasted());
    for (const PassReason reason : {PassReason::weak_test, PassReason::loose_fit})
        expect_twice(two.wasted_by(reason), one.wasted_by(reason));
}

TEST(Inspection, CountsTestsByDepth) {
    const MadeQuery query = some_query();
    const auto inspected = [&](const std::vector<TestedPair>& pairs) {
        return inspection(query.frame, attributed(query, pairs));
    };
    using Counts = std::vector<std::uint64_t>;
    const auto counts = [](const Inspection& of, std::uint64_t DepthInspection::*count) {
        Counts values;
        for (const DepthInspection& depth : of.depths) values.push_back(depth.*count);
        return values;
    };
    const auto by_weak_tests = [](const Inspection& of) {
        Counts values;
        for (const DepthInspection& depth : of.depths)
            values.push_back(depth.wasted.by(PassReason::weak_test));
        return values;
    };
    const Inspection found = inspected({meeting, loose, loose, weak, loose, loose}),
                     below_weak = inspected({meeting, weak, loose, loose, loose, loose});
    EXPECT_EQ(counts(found, &DepthInspection::tests), (Counts{1, 2, 2, 1}));
    Counts wasted;
    for (const DepthInspection& depth : found.depths) wasted.push_back(depth.wasted.all());
    EXPECT_EQ(wasted, (Counts{0, 0, 2, 1}));
    EXPECT_EQ(by_weak_tests(found), (Counts{0, 0, 0, 1}));
    EXPECT_EQ(by_weak_tests(below_weak), (Counts{0, 0, 2, 1}));
    EXPECT_EQ(found.depths[2].passed, (std::array<std::uint64_t, 5>{1, 0, 0, 0, 0}));
    Inspection sum = found;
    Inspection shallow;
    shallow.depths.resize(2);
    shallow.depths[1].tests = 7;
    sum += shallow;
    shallow += found;
    for (const Inspection* both : {&sum, &shallow}) {
        ASSERT_EQ(both->depths.size(), 4u);
        EXPECT_EQ(both->depths[1].tests, 9u);
        EXPECT_EQ(both->depths[3].wasted.by(PassReason::weak_test), 1u);
    }
}

TEST(Inspection, TheFrameWithTheMostWasteIsFirst) {
    const auto wasting = [](int frame, std::uint64_t tests) {
        InspectedFrame inspected{frame, {}};
        inspected.found.counts.wasted_for[0].volume_tests = tests;
        return inspected;
    };
    std::vector<InspectedFrame> frames = {wasting(1, 5), wasting(9, 7), wasting(3, 7)};
    sort_by_waste(frames);
    EXPECT_EQ(frames[0].frame, 3);
    EXPECT_EQ(frames[1].frame, 9);
    EXPECT_EQ(frames[2].frame, 1);
}

}  // namespace
}  // namespace scb
