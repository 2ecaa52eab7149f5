#include "core/analysis/hierarchy_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/analysis/measure_correlation.h"
#include "core/analysis/shared_volume.h"
#include "core/hierarchy/mesh_topology.h"
#include "core/volumes/measured_shape.h"
#include "tests/core/fit/point_sets.h"
#include "tests/core/hierarchy/built_mesh.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

HierarchyMeasures measured(const Mesh& mesh, VolumeKind kind, int threads = 1) {
    const MeshTopology shared = mesh_topology(mesh);
    const AnyHierarchy hierarchy = fit_any(kind, shared.topology, shared.points);
    return hierarchy_measures(
        hierarchy, measured_mesh(mesh, *shared.topology, shared.points, threads), threads);
}

/// The same triangle twice, the second moved along x.
Mesh two_triangles(const Vec3& a, const Vec3& b, const Vec3& c, double move) {
    Mesh mesh;
    mesh.vertices = {a, b, c};
    for (int i = 0; i < 3; ++i)
        mesh.vertices.push_back(
            Vec3(mesh.vertices[static_cast<std::size_t>(i)] + Vec3(move, 0, 0)));
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    return mesh;
}

TEST(HierarchyMeasures, AreThoseOfATreeMeasuredByHand) {
    // Flat boxes of 1 x 1 in one of 4 x 1: areas 2, 2 and 8.
    const HierarchyMeasures m =
        measured(two_triangles({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 3), VolumeKind::aabb);
    ASSERT_EQ(m.levels.size(), 2u);
    EXPECT_DOUBLE_EQ(m.levels[0].sah_cost, 1.2);
    EXPECT_DOUBLE_EQ(m.levels[1].sah_cost, 4.0 / 8);
    EXPECT_DOUBLE_EQ(m.all.sah_cost, 1.7);
    EXPECT_DOUBLE_EQ(m.all.area, 12);
    EXPECT_DOUBLE_EQ(m.surface, 1);
    EXPECT_EQ(m.all.nodes, 3u);
    EXPECT_EQ(m.all.leaves, 2u);
    EXPECT_EQ(m.all.solid, 0u) << "everything is in a plane";
    EXPECT_EQ(m.all.volume, 0);
    EXPECT_EQ(m.all.epo, 0) << "no leaf has a part of the other's triangle";
    EXPECT_EQ(m.all.overlap_volume, 0);
}

TEST(HierarchyMeasures, OverlapIsThatOfBoxesMeasuredByHand) {
    // Boxes [0, 2]^3 and [1, 3] x [0, 2]^2. A quarter of the first triangle has x > 1, three of
    // four parts of the second have x < 2.
    const HierarchyMeasures m =
        measured(two_triangles({0, 0, 0}, {2, 2, 0}, {0, 2, 2}, 1), VolumeKind::aabb);
    EXPECT_NEAR(m.all.epo, 0.5, 4 * m.epo_error);
    EXPECT_LT(m.epo_error, 0.005);
    EXPECT_EQ(m.levels[0].epo, 0) << "all of the mesh belongs to the root";
    EXPECT_EQ(m.levels[1].epo, m.all.epo);
    EXPECT_NEAR(m.levels[1].overlap_volume, 4, 0.05);
    EXPECT_DOUBLE_EQ(m.levels[1].volume, 16);
}

TEST(HierarchyMeasures, SiblingOverlapIsAShareOfTheSmallerOne) {
    // Tetrahedra in boxes [0, 4]^3 and [3, 6] x [1, 4]^2.
    Mesh mesh;
    for (const auto& [corner, side] : {std::pair(Vec3(0, 0, 0), 4.0), {Vec3(3, 1, 1), 3.0}}) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const Vec3& v : {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(1, 0, 1), Vec3(0, 1, 1)})
            mesh.vertices.emplace_back(corner + side * v);
        for (const Triangle& t : {Triangle{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}})
            mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    const HierarchyMeasures m = measured(mesh, VolumeKind::aabb);
    EXPECT_EQ(m.levels[1].solid_siblings, 1u);
    EXPECT_NEAR(m.levels[1].sibling_overlap, 9.0 / 27, 0.02);
    EXPECT_NEAR(m.levels[1].overlap_volume, 9, 0.1);
}

TEST(HierarchyMeasures, OneTriangleIsMetByEveryLine) {
    Mesh mesh = two_triangles({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0);
    mesh.triangles.pop_back();
    for (const VolumeKind kind : all_volume_kinds()) {
        const HierarchyMeasures m = measured(mesh, kind);
        EXPECT_EQ(m.leaf_count, 1) << volume_kind_name(kind);
        EXPECT_EQ(m.lcv, 0);
        EXPECT_EQ(m.all.epo, 0);
        EXPECT_EQ(m.all.sah_cost, 1) << "the root is a leaf";
    }
}

TEST(HierarchyMeasures, ABoxIsAsTightAsItsHull) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) mesh.vertices.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {4, 6, 5}, {5, 6, 7}, {0, 4, 1}, {1, 4, 5},
                      {2, 3, 6}, {3, 7, 6}, {0, 2, 4}, {2, 6, 4}, {1, 5, 3}, {3, 5, 7}};
    EXPECT_DOUBLE_EQ(measured(mesh, VolumeKind::aabb).levels[0].tightness, 1);
    EXPECT_NEAR(measured(mesh, VolumeKind::ball).levels[0].tightness,
                1 / (std::numbers::pi * std::sqrt(3) / 2), 1e-9);
}

TEST(HierarchyMeasures, NoVolumeIsSmallerThanItsHull) {
    const Mesh mesh = random_soup(7, unless_sanitized(300, 25), 0.3);
    for (const VolumeKind kind : all_volume_kinds())
        for (const LevelMeasures& level : measured(mesh, kind).levels) {
            EXPECT_LE(level.hull_volume, level.volume * (1 + 1e-9)) << volume_kind_name(kind);
            EXPECT_LE(level.tightness, 1 + 1e-9);
            EXPECT_LE(level.sibling_overlap, 1);
        }
}

TEST(HierarchyMeasures, SumUpOverLevels) {
    for (const VolumeKind kind : all_volume_kinds()) {
        const HierarchyMeasures m = measured(random_soup(8, unless_sanitized(200, 20), 0.3), kind);
        double epo = 0, sah_cost = 0, area = 0;
        for (const LevelMeasures& level : m.levels) {
            epo += level.epo;
            sah_cost += level.sah_cost;
            area += level.area;
        }
        EXPECT_NEAR(epo, m.all.epo, 1e-9 * epo);
        EXPECT_NEAR(sah_cost, m.all.sah_cost, 1e-9 * sah_cost);
        EXPECT_NEAR(area, m.all.area, 1e-9 * area);
        EXPECT_GT(epo, 0);
    }
}

TEST(HierarchyMeasures, AreTheSameForAnyNumberOfThreads) {
    const Mesh mesh = random_soup(9, unless_sanitized(3000, 30), 0.1);
    for (const VolumeKind kind : all_volume_kinds()) {
        if (unless_sanitized(false, kind != VolumeKind::scb && kind != VolumeKind::rss)) continue;
        const HierarchyMeasures one = measured(mesh, kind, 1), four = measured(mesh, kind, 4);
        for (std::size_t i = 0; i < cost_predictors().size(); ++i)
            EXPECT_EQ(cost_predictors()[i].of(one), cost_predictors()[i].of(four))
                << cost_predictors()[i].name;
        ASSERT_EQ(one.levels.size(), four.levels.size());
        for (std::size_t i = 0; i < one.levels.size(); ++i) {
            EXPECT_EQ(one.levels[i].epo, four.levels[i].epo);
            EXPECT_EQ(one.levels[i].hull_volume, four.levels[i].hull_volume);
            EXPECT_EQ(one.levels[i].overlap_volume, four.levels[i].overlap_volume);
        }
        EXPECT_EQ(one.lcv_error, four.lcv_error);
    }
}

// An error of the samples shows here: other draws of them, twice as many.
TEST(HierarchyMeasures, SharedPointsAreTheLensOfTwoBalls) {
    const Ball a{{0, 0, 0}, 1}, b{{1, 0, 0}, 1};
    const double lens = 5 * std::numbers::pi / 12, share = lens / volume(a);
    const std::vector<Vec3> points = halton_points(4096);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const SharedPoints found = shared_points(a, b, points, seed);
        EXPECT_NEAR(found.share(), share, 3 * std::sqrt(found.variance()));
    }
    EXPECT_EQ(shared_points(a, Ball{{3, 0, 0}, 1}, points, 1).shared, 0u);
    EXPECT_EQ(shared_points(a, Ball{{0, 0, 0}, 2}, points, 1).share(), 1);
}

TEST(HierarchyMeasures, SamplesAreSpreadByArea) {
    // Areas 1/2 and 3/2.
    Mesh mesh = two_triangles({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0);
    mesh.vertices[4][0] = 3;
    std::size_t first = 0;
    for (const SurfaceSample& s : surface_samples(mesh, 1000)) {
        first += s.triangle == 0;
        EXPECT_GE(s.point.minCoeff(), 0);
        EXPECT_LE(s.point[0] / (s.triangle == 0 ? 1 : 3) + s.point[1], 1 + 1e-12);
    }
    EXPECT_NEAR(static_cast<double>(first), 250, 1);
    // Within a triangle, too.
    mesh.triangles.pop_back();
    Vec3 sum = Vec3::Zero();
    for (const SurfaceSample& s : surface_samples(mesh, 4000)) sum += s.point / 4000;
    EXPECT_NEAR(sum[0], 1.0 / 3, 0.02);
    EXPECT_NEAR(sum[1], 1.0 / 3, 0.02);
    mesh.triangles = {{0, 0, 1}};
    EXPECT_TRUE(surface_samples(mesh, 10).empty());
}

TEST(HierarchyMeasures, MeshesWithoutAreaHaveNothingToSample) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 1, 1}};
    mesh.triangles = {{0, 0, 1}, {0, 1, 1}};
    for (const VolumeKind kind : all_volume_kinds()) {
        const HierarchyMeasures m = measured(mesh, kind);
        EXPECT_EQ(m.all.epo, 0);
        EXPECT_EQ(m.leaf_count, 0);
        EXPECT_TRUE(std::isfinite(m.all.sah_cost));
    }
}

}  // namespace
}  // namespace scb
