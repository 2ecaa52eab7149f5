#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/app/program.h"
#include "tests/shared_folder.h"
#include "tests/temporary_folder.h"

namespace scb::app {
namespace {

/// A recording of a situation that somebody reported, and the expected output of `scb inspect`.
struct Case {
    const char* file;
    int status;
    std::vector<std::string> texts;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"02-quantized-round-trip/02.scbrec", 0, {"\nValid.\n"}},
        {"03-fcl-broadphase-stale/03.scbrec",
         1,
         {"node 3 does not contain triangle 24, by 3 (since frame 1; stale: the volume dates "
          "from frame 0)",
          "the mesh of frame 0. With it, 11 of 11 nodes",
          "26: below a node that does not contain the triangle"}},
        {"03-fcl-broadphase-stale/03r.scbrec",
         1,
         {"stale: the volume dates from frame 0",
          "26: below a node that does not contain the triangle"}},
        {"03-fcl-broadphase-stale/03-opaque.scbrec",
         4,
         {"\nNothing wrong in what could be judged.\n",
          "\nNot judged: 6 of 6 leaf volumes of tree 0 \"manager\": the extents of their objects "
          "were not recorded"}},
        {"04-fcl-touching-boxes/04-0.scbrec", 0, {"\nValid.\n", "62 pairs reported, 62 intersect"}},
        {"04-fcl-touching-boxes/04-1.scbrec", 0, {"\nValid.\n", "47 pairs reported, 47 intersect"}},
        {"04-fcl-touching-boxes/04-2.scbrec", 0, {"\nValid.\n", "12 pairs reported, 12 intersect"}},
        {"05-nan-vertex/05.scbrec",
         1,
         {"triangle 100 has vertex 144, which is not finite", "8 nodes have volumes that are none",
          "32: rejected at a node whose volume is none",
          "of which node 0 of A has a volume that is none"}},
        {"06-stale-inertial-frame/06.scbrec",
         1,
         {"a rotation by 35 degrees about z. With it, 71 of 71 nodes contain", "48 missed"}},
        {"08-cgal-triangle-box/08-old.scbrec",
         0,
         {"farthest apart of the false ones: frame 0, A and triangle: nodes 0 of A and 0 of B"}},
        {"09-self-intersection-false/09-one.scbrec",
         1,
         {"4: the two triangles share a vertex and meet nowhere else"}},
        // Two bodies at one place touch in each vertex.
        {"09-self-intersection-false/09.scbrec",
         4,
         {"\nNot judged: 119 of 124 pairs: their distance or depth"}},
        {"10-false-triangle-pairs/10.scbrec", 1, {"3 false pairs", "0.437592 apart"}},
        {"11-refit-to-scene-bounds/11.scbrec",
         0,
         {"\nValid.\n", "\nCost: ", "boxes of tree 0 \"A\" since frame 1 are much larger"}},
        {"11-refit-to-scene-bounds/11b.scbrec",
         0,
         {"\nValid.\n",
          "\nCost: 396 of 399 boxes of tree 0 \"A\" since frame 1 are much larger than "
          "what "
          "is below them; with boxes that fit, 4,377 of 93,249 tests"}},
        {"12-leaf-index-mapping/12.scbrec",
         1,
         {"the triangles in another order", "With it, 63 of 63 nodes contain", "4 missed"}},
        {"13-infinite-plane/13.scbrec",
         1,
         {"1 test that went wrong", "at stage \"support\"", "nodes 14 of A and 0 of B, test 34"}},
        {"13-infinite-plane/finite.jsonl", 1, {"nodes 14 of A and 0 of B, test 34"}},
        {"16-far-from-origin/16.scbrec",
         4,
         {"\nNot judged: 248 of 248 triangles or leaf volumes: at frame 1 the tolerance is 0.5",
          "bodies stand 2e+06 from the origin, where 32-bit numbers are"}},
        {"16-far-from-origin/16t.scbrec", 1, {"8 pairs missed, 8 false pairs"}},
        {"16-far-from-origin/shifted-by-1.jsonl", 1, {"28 false pairs"}},
        {"17-deep-chain/17.scbrec",
         0,
         {"\nValid.\n",
          "\nCost: tree 0 \"A\" is 1,999 deep, where 11 would do; this project's "
          "hierarchies take 0.067 of the tests"}},
        {"20-order-after-update/20.scbrec", 0, {"\nValid.\n"}},
        {"20-order-after-update/20b.scbrec", 0, {"\nValid.\n"}},
        {"21-ray-on-edge/21.scbrec",
         4,
         {"\nNot judged: 162 of 166 pairs: their distance or depth"}},
        {"23-scaled-pose/23-scale.jsonl", 1, {"B is scaled by 2 by its pose at frame 0"}},
        {"23-scaled-pose/23-mirror.jsonl", 1, {"B is mirrored by its pose at frame 0"}},
        {"23-scaled-pose/23-column.jsonl", 1, {"fit the pose without its rotation"}},
        {"24-late-onset-masked/masked.jsonl",
         1,
         {"since frame 0, by 1e-05 there; by 4.00001 at frame 1; stale: the volume dates "
          "from frame 0"}},
        {"24-late-onset-masked/plain.jsonl", 1, {"since frame 1; stale"}},
        {"30-spatial-split/sbvh.scbrec", 0, {"\nValid.\n"}},
        {"30-spatial-split/sbvh.jsonl", 0, {"\nValid.\n"}},
        {"31-repeated-test/rep.scbrec",
         0,
         {"\nValid.\n", "\nCost: 1 of 2 tests of volumes repeat"}},
        {"31-repeated-test/rep.jsonl", 0, {"\nValid.\n"}},
        // The pair touches.
        {"32-scaled-body/scale.scbrec", 4, {"Scale: B is scaled by 2"}},
        {"32-scaled-body/scale.jsonl", 4, {"\nNothing wrong in what could be judged.\n"}},
        {"33-body-told-again/retold.scbrec", 0, {"\nValid.\n"}},
        {"33-body-told-again/retold.jsonl", 0, {"\nValid.\n"}},
        {"34-chain-cubic/c500.scbrec", 1, {"500 pairs missed", "499 deep"}},
        {"35-bodies-cubic/m.scbrec", 0, {"\nValid.\n"}},
        {"35-bodies-cubic/ms.scbrec", 0, {"\nValid.\n"}},
        {"36-names-replaced/obj.scbrec", 1, {"stage \"triangle-box\""}},
        {"36-names-replaced/obj.jsonl", 1, {"stage \"triangle-box\""}},
    };
    return all;
}

class SharedCase : public testing::TestWithParam<std::size_t> {
  protected:
    void SetUp() override {
        if (shared_folder().empty()) GTEST_SKIP() << "there is no ../shared";
    }
};

TEST_P(SharedCase, HasItsVerdictItsCauseAndItsNumbers) {
    const Case& of = cases()[GetParam()];
    const ProgramRun run =
        run_scb("--quiet --no-config inspect --full " + shared_folder() + "/cases/" + of.file);
    EXPECT_EQ(run.status, of.status) << run.err;
    for (const std::string& text : of.texts)
        EXPECT_NE(("\n" + run.out).find(text), std::string::npos) << text << "\n" << run.out;
}

INSTANTIATE_TEST_SUITE_P(All, SharedCase, testing::Range<std::size_t>(0, cases().size()));

class SharedCases : public testing::Test {
  protected:
    void SetUp() override {
        if (shared_folder().empty()) GTEST_SKIP() << "there is no ../shared";
    }
};

TEST_F(SharedCases, AreAllTested) {
    for (const auto& file :
         std::filesystem::recursive_directory_iterator(shared_folder() + "/cases")) {
        const std::string ending = file.path().extension().string();
        if (ending != ".scbrec" && ending != ".jsonl") continue;
        const std::string path =
            std::filesystem::relative(file.path(), shared_folder() + "/cases").string();
        EXPECT_TRUE(std::any_of(cases().begin(), cases().end(), [&path](const Case& of) {
            return path == of.file;
        })) << path;
    }
}

TEST_F(SharedCases, ATestOfAnEngineWhoseTestsAreExactIsWrong) {
    const TemporaryFolder folder;
    const std::string lines = folder / "x.jsonl";
    const ProgramRun converted = run_scb("convert " + shared_folder() +
                                         "/cases/08-cgal-triangle-box/08-old.scbrec -o " + lines);
    ASSERT_EQ(converted.status, 0) << converted.err;
    folder.write("exact.jsonl", "{\"setting\":\"tests\",\"value\":\"exact\"}\n" + file_text(lines));
    const ProgramRun run = run_scb("--quiet inspect --full " + folder / "exact.jsonl");
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("a test of an engine whose tests are exact passed volumes that are "
                           "apart"),
              std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("nodes 0 of A and 0 of B, test 0, 1.9"), std::string::npos) << run.out;
}

TEST_F(SharedCases, CollideAndInspectAgreeOnWhatTouches) {
    const ProgramRun run = run_scb("--quiet collide " + shared_folder() +
                                   "/cases/09-self-intersection-false/09.scbrec");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("5        0        0\n"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("119 of these pairs have a distance or depth within the tolerance"),
              std::string::npos)
        << run.out;
}

TEST_F(SharedCases, OneBodyInsideTheOtherIsSaid) {
    const ProgramRun run = run_scb("--quiet collide " + shared_folder() +
                                   "/cases/19-one-inside-the-other/nested.json");
    EXPECT_NE(run.out.find("No triangles intersect: inner lies inside outer."), std::string::npos)
        << run.out;
}

TEST_F(SharedCases, ChildrenInAnotherOrderAreTheSamePairs) {
    const std::string folder = shared_folder() + "/cases/20-order-after-update/";
    const ProgramRun run = run_scb("--quiet diff " + folder + "20.scbrec " + folder + "20b.scbrec");
    EXPECT_NE(run.out.find("Both found the same pairs."), std::string::npos) << run.out;
}

}  // namespace
}  // namespace scb::app
