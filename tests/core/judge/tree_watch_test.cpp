#include "core/judge/tree_watch.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/core/judge/judged_tree.h"

namespace scb {
namespace {

TEST(TreeWatch, NamesANodeThatGotOtherChildrenAndKeptItsVolume) {
    EngineNodes tree = tree_of(nodes_of_row());
    const Mesh mesh = row_of_triangles();
    TreeWatch watch;
    TreeShape shape = tree_shape(tree, 4);
    watch.look(0, {tree, shape, &mesh, 1e-9, 1, 1});
    // A rotation: leaf 6 changes places with leaf 3. The box of node 2 is updated, the box of node
    // 1 is not.
    const std::array<std::uint32_t, 2> of_1{6, 4}, of_2{5, 3};
    tree.relink(1, 0, 1, of_1, {});
    tree.relink(2, 0, 1, of_2, {});
    tree.relink(6, 1, 0, {}, std::array<std::uint32_t, 1>{3});
    tree.relink(3, 2, 0, {}, std::array<std::uint32_t, 1>{0});
    tree.set_volume(2, box_of_row(0, 3), 1, "");
    shape = tree_shape(tree, 4);
    watch.look(1, {tree, shape, &mesh, 1e-9, 2, 2});
    const auto problems = watch.problems();
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].problem.node, 1u);
    EXPECT_EQ(problems[0].links_at, 1);
    EXPECT_EQ(problems[0].kept_from, 0);
}

TEST(TreeWatch, AProblemThatGoesAndComesAgainHasGaps) {
    for (const bool comes_again : {false, true}) {
        EngineNodes tree = tree_of(nodes_of_row());
        const Mesh mesh = row_of_triangles();
        const TreeShape shape = tree_shape(tree, 4);
        TreeWatch watch;
        int version = 0;
        for (const double last : {0.75, comes_again ? 1.75 : 0.75, 0.5}) {
            tree.set_volume(1, box_of_row(0, last), version, "");
            watch.look(version, {tree, shape, &mesh, 1e-9, 1, version + 1});
            ++version;
        }
        ASSERT_EQ(watch.problems().size(), 1u);
        EXPECT_EQ(watch.problems()[0].gaps, comes_again);
        EXPECT_EQ(watch.problems()[0].frames, comes_again ? 2u : 3u);
    }
}

TEST(TreeWatch, TellsAStaleVolumeFromOneThatNeverFitted) {
    EngineNodes tree = tree_of(nodes_of_row());
    Mesh mesh = row_of_triangles();
    const TreeShape shape = tree_shape(tree, mesh.triangles.size());
    tree.set_volume(1, box_of_row(0, 0.75), 0, "");
    TreeWatch watch;
    watch.look(0, {tree, shape, &mesh, 1e-9, 1, 1});
    watch.look(1, {tree, shape, &mesh, 1e-9, 1, 1});
    // Triangle 3 moves; the leaf is refitted, what is above it is not.
    for (std::uint32_t i = 9; i < 12; ++i) mesh.vertices[i] += Vec3(0, 1, 0);
    Obb moved = box_of_row(3, 3);
    moved.center[1] += 1;
    tree.set_volume(6, moved, 2, "");
    watch.look(2, {tree, shape, &mesh, 1e-9, 1, 2});
    watch.look(3, {tree, shape, &mesh, 1e-9, 1, 3});
    const auto problems = watch.problems();
    ASSERT_EQ(problems.size(), 3u);
    EXPECT_EQ(problems[0].words, "node 2 does not contain triangle 3, by 1");
    EXPECT_EQ(problems[1].words, "node 1 does not contain triangle 1, by 0.25")
        << "the worst first";
    EXPECT_EQ(problems[2].words, "node 0 does not contain triangle 3, by 1")
        << "nor do the nodes below it contain their triangles";
    EXPECT_FALSE(problems[1].stale);
    EXPECT_LT(problems[1].links_at, 0) << "its children are as they were";
    EXPECT_EQ(problems[1].frames, 4u);
    for (const std::size_t i : {0u, 2u}) {
        EXPECT_EQ(problems[i].problem.inherited, i == 2);
        EXPECT_TRUE(problems[i].stale);
        EXPECT_EQ(problems[i].since, 2);
        EXPECT_EQ(problems[i].recorded_at, 0);
        EXPECT_EQ(problems[i].frames, 2u);
    }
}

/// A row that is checked frame by frame. Node 1, of triangles 0 and 1, can get a box that ends
/// before them.
struct WatchedRow {
    EngineNodes tree = tree_of(nodes_of_row());
    Mesh mesh = row_of_triangles();
    TreeShape shape = tree_shape(tree, 4);
    TreeWatch watch;
    int version = 0, volume_version = 0;

    void look(int frame) { watch.look(frame, {tree, shape, &mesh, 1e-9, version, volume_version}); }
    void tell(int frame, double last) {
        tree.set_volume(1, box_of_row(0, last), frame, "");
        ++volume_version;
    }
};

TEST(TreeWatch, TellsTheFrameAtWhichAVolumeIsWorst) {
    WatchedRow row;
    int frame = 0;
    for (const double last : {0.75, 0.25, 0.5}) {
        row.tell(frame, last);
        row.look(frame++);
    }
    ASSERT_EQ(row.watch.problems().size(), 1u);
    const WatchedProblem problem = row.watch.problems()[0];
    EXPECT_EQ(problem.problem.amount, 0.75);
    EXPECT_EQ(problem.words, "node 1 does not contain triangle 1, by 0.75");
    EXPECT_EQ(problem.since, 0);
    EXPECT_EQ(problem.since_amount, 0.25);
    EXPECT_EQ(problem.worst_at, 1);
    EXPECT_FALSE(problem.stale) << "the worst volume was recorded there";
    EXPECT_EQ(problem.frames, 3u);
}

// A small error of the first frame must not hide that the box was never refitted.
TEST(TreeWatch, AVolumeIsStaleWhereItBecameTwiceAsWrong) {
    WatchedRow row;
    row.tell(0, 0.99);
    row.look(0);
    for (std::uint32_t i = 3; i < 6; ++i) row.mesh.vertices[i] += Vec3(0.5, 0, 0);
    ++row.volume_version;
    row.look(1);
    const auto problems = row.watch.problems();
    const auto node = std::find_if(problems.begin(), problems.end(),
                                   [](const WatchedProblem& p) { return p.problem.node == 1; });
    ASSERT_NE(node, problems.end());
    EXPECT_EQ(node->since, 0);
    EXPECT_NEAR(node->since_amount, 0.01, 1e-12);
    EXPECT_EQ(node->worst_at, 1);
    EXPECT_NEAR(node->problem.amount, 0.51, 1e-12);
    EXPECT_TRUE(node->stale);
    EXPECT_EQ(node->recorded_at, 0);
}

TEST(TreeWatch, AFrameCountsOnceHoweverManyQueriesItHas) {
    WatchedRow row;
    row.tell(0, 0.75);
    for (const int frame : {0, 0, 1, 1, 2}) row.look(frame);
    row.tell(2, 0.5);
    row.look(2);
    ++row.version;
    row.look(2);
    EXPECT_EQ(row.watch.problems()[0].frames, 3u);
    row.tell(3, 1);
    for (const int frame : {3, 4}) row.look(frame);
    EXPECT_EQ(row.watch.problems()[0].frames, 3u) << "it is mended";
}

TEST(TreeWatch, AVolumeIsStaleWhereItWasRightWhenItWasTold) {
    for (const bool looked_when_recorded : {true, false}) {
        WatchedRow row;
        row.look(0);
        row.tell(1, 1);
        if (looked_when_recorded) row.look(1);
        // Triangle 1 moves, and no volume with it.
        for (std::uint32_t i = 3; i < 6; ++i) row.mesh.vertices[i] += Vec3(0, 0.5, 0);
        ++row.volume_version;
        row.look(2);
        for (const WatchedProblem& problem : row.watch.problems())
            if (problem.problem.node == 1) {
                EXPECT_EQ(problem.stale, looked_when_recorded);
                EXPECT_EQ(problem.recorded_at, 1);
                EXPECT_EQ(problem.since, 2);
            }
        EXPECT_EQ(row.watch.problems().size(), 3u) << "nodes 4, 1 and 0";
    }
}

TEST(TreeWatch, AProblemOfTheShapeIsToldWhereItIsNew) {
    auto nodes = nodes_of_row();
    nodes[4].items = {};
    const EngineNodes tree = tree_of(nodes);
    const Mesh mesh = row_of_triangles();
    const TreeShape shape = tree_shape(tree, 4);
    TreeWatch watch;
    for (int frame = 0; frame < 4; ++frame) watch.look(frame, {tree, shape, &mesh, 1e-9, frame, 0});
    ASSERT_EQ(watch.problems().size(), 1u) << "recorded again, it is the same";
    EXPECT_EQ(watch.problems()[0].words, "triangle 1 is in no leaf");
    EXPECT_EQ(watch.problems()[0].since, 0);
}

}  // namespace
}  // namespace scb
