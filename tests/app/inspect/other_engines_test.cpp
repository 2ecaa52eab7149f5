#include <gtest/gtest.h>

#include "tests/app/program.h"
#include "tests/recordings/broadphase_engine.h"
#include "tests/recordings/split_engine.h"
#include "tests/temporary_folder.h"

namespace scb::app {
namespace {

ProgramRun inspected_split(SplitBug bug) {
    const TemporaryFolder folder;
    record_split_engine(bug, folder / "x.scbrec");
    return run_scb("--quiet inspect --full " + folder / "x.scbrec");
}

ProgramRun inspected_broadphase(BroadphaseBug bug, bool extents) {
    const TemporaryFolder folder;
    record_broadphase(bug, extents, folder / "x.scbrec");
    return run_scb("--quiet inspect --full " + folder / "x.scbrec");
}

void expect_says(const ProgramRun& run, int status, const std::vector<std::string>& texts) {
    EXPECT_EQ(run.status, status) << run.out << run.err;
    for (const std::string& text : texts)
        EXPECT_NE(("\n" + run.out).find(text), std::string::npos) << text << "\n" << run.out;
}

TEST(OtherEngines, SpatialSplitsAreValid) {
    expect_says(inspected_split(SplitBug::none), 0, {"\nValid.\n"});
}

TEST(OtherEngines, APartThatNoLeafHasIsNamed) {
    expect_says(inspected_split(SplitBug::part_forgotten), 1,
                {"\nWrong: ", "does not contain its part of triangle"});
    expect_says(inspected_split(SplitBug::box_of_corners), 1,
                {"\nWrong: ", "does not contain its part of triangle"});
}

TEST(OtherEngines, ABroadphaseIsValidWhereItsObjectsAreKnown) {
    expect_says(inspected_broadphase(BroadphaseBug::none, true), 0, {"\nValid.\n"});
    expect_says(inspected_broadphase(BroadphaseBug::none, false), 4,
                {"\nNothing wrong in what could be judged.\n",
                 "\nNot judged: 40 of 40 leaf volumes of tree 0 \"world\": "});
}

TEST(OtherEngines, ALeafOfABroadphaseThatWasNotUpdatedIsNamed) {
    expect_says(inspected_broadphase(BroadphaseBug::leaf_not_updated, true), 1,
                {"does not contain object 5", "stale: the volume dates from frame 1",
                 "objects 5 of A and"});
    // Without the extents of objects nobody can tell.
    expect_says(inspected_broadphase(BroadphaseBug::leaf_not_updated, false), 4,
                {"\nNot judged: 40 of 40 leaf volumes"});
}

/// Objects have volumes, and no triangles that a camera could see.
TEST(OtherEngines, ObjectsArePictured) {
    const TemporaryFolder folder;
    record_broadphase(BroadphaseBug::none, true, folder / "x.scbrec");
    for (const char* command : {"pairs ", "pairs --camera contact ", "rejections ", "levels "}) {
        const ProgramRun run =
            run_scb("--quiet render " + std::string(command) + (folder / "x.scbrec") +
                    " --size 320x240 --samples 1 -o " + (folder / "out"));
        EXPECT_EQ(run.status, 0) << command << run.err;
        EXPECT_EQ(run.err, "") << command;
    }
}

TEST(OtherEngines, PairsThatABroadphaseLosesAreNamed) {
    for (const bool extents : {true, false})
        expect_says(inspected_broadphase(BroadphaseBug::pair_order, extents), 1,
                    {"\nWrong: ", " pairs missed"});
}

}  // namespace
}  // namespace scb::app
