#include "core/judge/query_overlaps.h"

#include <gtest/gtest.h>

#include "tests/core/judge/judged_rows.h"

namespace scb {
namespace {

using Counts = std::vector<std::size_t>;

TEST(QueryOverlaps, CountsTheOverlapsOfEachLevel) {
    Rows rows;
    EXPECT_EQ(level_overlaps(rows.query, 100), (Counts{1, 2, 4}));
    EXPECT_EQ(level_overlaps(rows.query, 3), (Counts{1, 2}));
    // One unit along the row: of four triangles three have a partner.
    rows.query.b_to_a.translation[0] += 1;
    EXPECT_EQ(level_overlaps(rows.query, 100), (Counts{1, 3, 3}));
    rows.query.b_to_a.translation[2] += 10;
    EXPECT_EQ(level_overlaps(rows.query, 100), Counts{0});
}

TEST(QueryOverlaps, NodesWithoutVolumesOverlapAllOthers) {
    auto nodes = nodes_of_row();
    for (ToldNode& node : nodes) node.volume = NodeVolume{};
    const Rows rows(nodes);
    EXPECT_EQ(level_overlaps(rows.query, 100), (Counts{1, 4, 16}));
}

TEST(QueryOverlaps, NothingIsCountedOfABodyAgainstItselfOrOfAPoseThatIsNotRigid) {
    Rows rows;
    rows.query.self = true;
    EXPECT_EQ(level_overlaps(rows.query, 100), Counts{});
    rows.query.self = false;
    rows.query.placed = false;
    EXPECT_EQ(level_overlaps(rows.query, 100), Counts{});
}

}  // namespace
}  // namespace scb
