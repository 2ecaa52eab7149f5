#include "app/study/layout_time.h"

#include <gtest/gtest.h>

#include "core/analysis/assumed_time.h"

namespace scb::app {
namespace {

TEST(LayoutTime, IsTheSumOfTestsTrianglesAndPairs) {
    Collision found;
    found.n_v = 100;
    found.n_p = 10;
    found.pairs.resize(3);
    EXPECT_EQ(layout_time(VolumeKind::scb2, {PackedLayout::Numbers::quantized}, 100, 10, 3),
              100u * 5'290 + 10u * 7'900 + 3u * 40'000);
    for (const PackedLayout& layout : all_packed_layouts()) {
        const std::uint64_t one = layout_time(VolumeKind::scb, layout, 100, 10, 3);
        EXPECT_LT(one, layout_time(VolumeKind::scb2, layout, 100, 10, 3))
            << packed_layout_name(layout);
        EXPECT_LT(one, assumed_time(VolumeKind::scb, {}, DescentRule::radius, found));
    }
}

}  // namespace
}  // namespace scb::app
