#include <gtest/gtest.h>

#include "core/analysis/trace_words.h"
#include "scb/error.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

Trace slide_of(const TraceHeader& header) {
    static const BuiltMesh a(random_soup(1, 400, 0.15)), b(random_soup(2, 300, 0.15));
    // Frame 2 is in contact, the others are not.
    return record_trace(a, b, header, {2, 40, 60}, -0.1);
}
Trace distances(DistanceOrder order = DistanceOrder::nearest) {
    return slide_of(asking_distance(VolumeKind::scb2, {.order = order}));
}

TEST(DistanceDiff, TheSameTraceIsEqual) {
    for (const Trace& trace : {distances(), slide_of(asking_within(VolumeKind::ball, 0.2))}) {
        const TraceDiff d = diff(trace, trace);
        EXPECT_TRUE(d.equal());
        EXPECT_FALSE(d.first);
        EXPECT_EQ(d.common, 3u);
    }
}

TEST(DistanceDiff, DistancesAreEqualUpToRounding) {
    const Trace a = distances();
    ASSERT_GT(a.frames[1].nearest->distance, 0);
    ASSERT_EQ(a.frames[0].nearest->distance, 0);
    Trace b = a;
    b.frames[1].nearest->distance += 0.5e-15;
    EXPECT_TRUE(diff(a, b).equal());
    b.frames[1].nearest->distance += 4e-15;
    const TraceDiff d = diff(a, b);
    EXPECT_FALSE(d.equal());
    ASSERT_EQ(d.frames.size(), 1u);
    EXPECT_EQ(d.frames[0].frame, 40);
    EXPECT_TRUE(d.frames[0].distances_differ());
    EXPECT_FALSE(d.frames[0].triangles_differ());
    // The larger rounding counts: recordings of engines have none.
    b.frames[1].rounding = 0;
    EXPECT_FALSE(diff(a, b).equal());
    b.frames[1].rounding = 1;
    EXPECT_TRUE(diff(a, b).equal());
    EXPECT_TRUE(diff(b, a).equal());
}

TEST(DistanceDiff, OtherTrianglesDifferUnlessTheyIntersect) {
    const Trace a = distances();
    Trace b = a;
    for (QueryTrace& frame : b.frames) ++frame.found.pairs[0].b;
    const TraceDiff d = diff(a, b);
    ASSERT_EQ(d.frames.size(), 2u);
    EXPECT_EQ(d.frames[0].frame, 40);
    EXPECT_TRUE(d.frames[0].triangles_differ());
    EXPECT_FALSE(d.frames[0].distances_differ());
}

TEST(DistanceDiff, OneWithoutTrianglesDiffers) {
    const Trace a = distances();
    Trace b = a;
    b.frames[2].nearest.reset();
    b.frames[2].found.pairs.clear();
    for (const TraceDiff& d : {diff(a, b), diff(b, a)}) {
        ASSERT_EQ(d.frames.size(), 1u);
        EXPECT_TRUE(d.frames[0].distances_differ());
    }
}

TEST(DistanceDiff, TwoOrdersPartAtATestWithTheSameDistances) {
    const TraceDiff d = diff(distances(), distances(DistanceOrder::depth_first));
    EXPECT_FALSE(d.equal());
    ASSERT_EQ(d.asked.size(), 1u);
    EXPECT_EQ(d.asked[0].name, "order");
    ASSERT_TRUE(d.first && d.first->a && d.first->b);
    EXPECT_TRUE(d.first->a->test.nodes != d.first->b->test.nodes ||
                d.first->a->outcome != d.first->b->outcome);
    for (const FrameDifference& frame : d.frames)
        EXPECT_FALSE(frame.distances_differ() || frame.triangles_differ()) << frame.frame;
    const std::string words = words_of(*d.first, d.bodies);
    EXPECT_NE(words.find("near"), std::string::npos) << words;
    EXPECT_EQ(words.find("overlap"), std::string::npos) << words;
    EXPECT_EQ(words.find("intersect"), std::string::npos) << words;
}

TEST(DistanceDiff, AChangedTestIsFound) {
    const Trace a = distances();
    Trace b = a;
    Step& changed = b.frames[1].steps.volumes[17];
    changed.stage = changed.stage == Stage::slab_a ? Stage::slab_b : Stage::slab_a;
    const TraceDiff d = diff(a, b);
    ASSERT_TRUE(d.first);
    EXPECT_EQ(d.first->frame, 40);
    EXPECT_EQ(d.first->test, 17u);
}

TEST(DistanceDiff, AWiderToleranceFindsMorePairs) {
    const Trace near = slide_of(asking_within(VolumeKind::scb2, 0.05)),
                wide = slide_of(asking_within(VolumeKind::scb2, 0.06));
    const TraceDiff d = diff(near, wide);
    EXPECT_EQ(d.pairs_only_in_a, 0u);
    EXPECT_GT(d.pairs_only_in_b, 0u);
    ASSERT_FALSE(d.lost.empty());
    const std::string words = words_of(d.lost[0], false, d.bodies);
    EXPECT_NE(words.find("the first left them out at test"), std::string::npos) << words;
    EXPECT_EQ(words.find("overlap"), std::string::npos) << words;
}

TEST(DistanceDiff, TwoKindsAreRefused) {
    const Trace smallest = distances(), all = slide_of(asking_within(VolumeKind::scb2, 0.1)),
                overlap = slide_of(asking(VolumeKind::scb2, OverlapTest::symmetric));
    for (const auto& [a, b] :
         {std::pair(&smallest, &all), std::pair(&smallest, &overlap), std::pair(&overlap, &all)}) {
        EXPECT_THROW(diff(*a, *b), InputError);
        EXPECT_THROW(diff(*b, *a), InputError);
    }
}

}  // namespace
}  // namespace scb
