#include "core/overlap/stage_table.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace scb {
namespace {

TEST(StageTable, HasTheRowsOfThisProject) {
    const StageTable stages;
    std::size_t endings = 0, rejections = 0;
    for (std::size_t i = 0; i < named_stage_count; ++i) {
        const auto stage = static_cast<Stage>(i);
        EXPECT_EQ(stages.row(stage).name, stage_name(stage));
        EXPECT_EQ(stages.row(stage).group.empty(), !is_ending(stage));
        endings += is_ending(stage);
        rejections += is_rejection(stage);
    }
    EXPECT_EQ(rejections, stage_count - 1);
    EXPECT_EQ(endings, rejections + 5);
    EXPECT_THROW(stages.row(static_cast<Stage>(named_stage_count)), std::out_of_range);
}

TEST(StageTable, AnEnginesStageIsTheProjectsOnlyIfItRejects) {
    StageTable stages;
    EXPECT_EQ(stages.add("slab-ball"), Stage::slab_ball);
    for (const char* name : {"overlapping", "found", "divided a", "sphere"}) {
        const Stage added = stages.add(name);
        EXPECT_GE(static_cast<std::size_t>(added), named_stage_count) << name;
        EXPECT_EQ(stages.row(added).name, name);
        EXPECT_TRUE(is_rejection(added) && is_ending(added));
        EXPECT_EQ(stages.add(name), added) << "a name has one row";
    }
}

TEST(StageTable, NineStagesOfAnEngineHaveColorsOfTheirOwn) {
    StageTable stages;
    std::set<Hue> hues;
    for (std::size_t i = 0; i < StageTable::most_rows - named_stage_count; ++i) {
        const Stage stage = stages.add("stage " + std::to_string(i));
        hues.insert(hue_of(stage));
        const StageRow row = stages.row(stage);
        EXPECT_EQ(row.group, i < 9 ? row.name : "other stages");
        EXPECT_EQ(hues.size(), std::min<std::size_t>(i + 1, 10));
    }
    EXPECT_THROW(stages.add("one more"), std::length_error);
}

}  // namespace
}  // namespace scb
