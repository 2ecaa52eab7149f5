#include "scb/packed_hierarchy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "scb/error.h"
#include "tests/core/fit/point_sets.h"
#include "tests/core/packed/packed_variants.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

std::vector<Mesh> all_kinds() {
    std::vector<Mesh> meshes = assorted_meshes(61, {1, 2, 3, 4, 5, 7, 8, 9, 26, 27, 300});
    Mesh tiny = height_field(8);
    for (Vec3& v : tiny.vertices) v *= 1e-7;
    meshes.push_back(tiny);
    return meshes;
}

TEST(PackedHierarchy, EveryKindOfMeshIsValidInEveryLayout) {
    for (const Mesh& mesh : all_kinds()) {
        const BuiltMesh built(mesh);
        for_each_layout([&]<class Codec>(LayoutOf<Codec>, const char* name) {
            for (int leaf = 1; leaf <= most_leaf_triangles; ++leaf)
                for (const LeafCorners corners : {LeafCorners::stored, LeafCorners::in_mesh})
                    EXPECT_EQ(validate(pack<Codec>(scb_of<typename Codec::Volume>(built), mesh,
                                                   leaf, corners),
                                       mesh),
                              "")
                        << name << ", " << mesh.triangles.size() << " triangles, " << leaf;
        });
    }
}

// Volumes without a radius, which roundings of their coordinates may not leave.
TEST(PackedHierarchy, HoldsTrianglesThatArePoints) {
    const auto expect_valid = [](const Mesh& mesh) {
        const BuiltMesh built(mesh);
        for_each_layout([&]<class Codec>(LayoutOf<Codec>, const char* name) {
            for (const int leaf : {1, 4})
                EXPECT_EQ(
                    validate(pack<Codec>(scb_of<typename Codec::Volume>(built), mesh, leaf), mesh),
                    "")
                    << name << ", " << leaf;
        });
    };
    expect_valid({{{0, 6.125e-06, 1.125e-06},
                   {-3.333333333333333e-07, 2e-07, 1e-14},
                   {-3.9375e-06, 1.75e-06, 3e-07}},
                  {{0, 1, 2}, {1, 1, 1}}});
    expect_valid({{{0, 6.125, 1.125}, {-1.0 / 3, 0.2, 1e-8}, {-3.9375, 1.75, 0.3}},
                  {{0, 1, 2}, {1, 1, 1}, {0, 2, 0}, {2, 2, 2}, {0, 0, 0}}});
    // All of them at the center of their node.
    for (const double far : {1.0, 1e6, 1e8})
        expect_valid({{{far, -far, far / 3}}, std::vector<Triangle>(9, {0, 0, 0})});
    Random random(17);
    for (int i = 0; i < 500; ++i) {
        const double size = std::pow(10.0, random.uniform(-6, 7));
        Mesh mesh;
        for (std::uint32_t v = 0; v < 4; ++v) {
            Vec3 point;
            for (int axis = 0; axis < 3; ++axis)
                point[axis] = size * std::pow(10.0, random.uniform(-9, 0)) *
                              (random.next() % 2 == 0 ? 1 : -1);
            if (v == 0) point = {size, -size, size};
            mesh.vertices.push_back(point);
            mesh.triangles.push_back({v, v, v});
        }
        mesh.triangles.push_back({0, 1, 2});
        expect_valid(mesh);
    }
}

TEST(PackedHierarchy, ValidateFindsWhatIsWrong) {
    const Mesh mesh = height_field(12);
    const auto right = pack<QuantizedCodec<4>>(build_hierarchy<Scb>(mesh), mesh, 3);
    const auto said = [&](auto break_it) {
        auto wrong = right;
        break_it(wrong);
        return validate(wrong, mesh);
    };
    using Packed = PackedHierarchy<QuantizedCodec<4>>;
    EXPECT_EQ(said([](Packed&) {}), "");
    EXPECT_NE(said([](Packed& p) { p.nodes[2].volumes.r[1] /= 2; }).find("child 1 of node 2"),
              std::string::npos);
    EXPECT_NE(said([](Packed& p) { p.nodes[1].volumes.h[0] /= 2; }).find("child 0 of node 1"),
              std::string::npos);
    EXPECT_NE(said([](Packed& p) { p.nodes[3].own.r *= 0.99f; }).find("volume of node 3"),
              std::string::npos);
    EXPECT_NE(said([](Packed& p) { p.nodes[0].reach *= 0.5f; }).find("reaches farther"),
              std::string::npos);
    EXPECT_NE(said([](Packed& p) { p.nodes[0].leaf_bits ^= 1; }).find("whether child 0 is a leaf"),
              std::string::npos);
    EXPECT_NE(
        said([](Packed& p) { p.nodes[0].child[1] = p.nodes[0].child[0]; }).find("exactly one"),
        std::string::npos);
    EXPECT_NE(said([](Packed& p) {
                  p.leaves[PackedLeaf::words_before<PackedScb> + PackedLeaf::header + 5] *= 1.1f;
              }).find("nearest float"),
              std::string::npos);
}

template <class Codec>
void expect_same(const PackedHierarchy<Codec>& a, const PackedHierarchy<Codec>& b) {
    ASSERT_EQ(a.leaves.size(), b.leaves.size());
    EXPECT_EQ(std::memcmp(a.leaves.data(), b.leaves.data(), a.leaves.size() * sizeof(float)), 0);
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (std::size_t i = 0; i < a.nodes.size(); ++i)
        ASSERT_EQ(std::memcmp(&a.nodes[i], &b.nodes[i], sizeof a.nodes[i]), 0) << i;
    EXPECT_EQ(a.root.bits, b.root.bits);
    EXPECT_EQ(a.reach, b.reach);
    EXPECT_EQ(a.leaf_radius, b.leaf_radius);
}

// Triangles of a grid in three directions, all alike and acute; of a strip, long and thin.
Mesh acute_grid(std::uint32_t side, double height) {
    Mesh mesh;
    for (std::uint32_t j = 0; j <= side; ++j)
        for (std::uint32_t i = 0; i <= side; ++i)
            mesh.vertices.push_back({i + 0.5 * j, height * j, 0.01 * (i * i + j)});
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const std::uint32_t at = j * (side + 1) + i;
            mesh.triangles.push_back({at, at + 1, at + side + 1});
            mesh.triangles.push_back({at + 1, at + side + 2, at + side + 1});
        }
    return mesh;
}

TEST(PackedHierarchy, BuiltAtOnceIsThatOfTheHierarchy) {
    std::vector<Mesh> meshes = all_kinds();
    for (const double height : {0.866, 0.5, 1e-3, 1e-9}) meshes.push_back(acute_grid(12, height));
    meshes.push_back(height_field(80));  // more than a thread takes at a time
    for (const Mesh& mesh : meshes)
        for (const SplitMethod split : {SplitMethod::section_3, SplitMethod::cost}) {
            const BuiltMesh built(mesh, build_topology(mesh, {.split = split}));
            const int first =
                mesh.triangles.size() < unless_sanitized(5000u, 30u) ? 1 : most_leaf_triangles;
            for_each_layout([&]<class Codec>(LayoutOf<Codec>, const char* name) {
                const auto& hierarchy = scb_of<typename Codec::Volume>(built);
                for (int leaf = first; leaf <= most_leaf_triangles; ++leaf) {
                    SCOPED_TRACE(std::string(name) + ", leaves of " + std::to_string(leaf));
                    const auto expected = pack<Codec>(hierarchy, mesh, leaf);
                    for (const int threads : {1, 3})
                        expect_same(
                            build_packed<Codec>(mesh, {.split = split, .threads = threads}, leaf),
                            expected);
                }
            });
        }
}

// All nodes would take twice as long to fit.
TEST(PackedHierarchy, BuiltAtOnceFitsOnlyThePackedNodes) {
    const Mesh mesh = height_field(40);
    FitCounts all, packed;
    const auto fitting = [](FitCounts& counts) {
        BuildOptions options;
        options.fit.counts = &counts;
        return options;
    };
    build_hierarchy<Scb2>(mesh, fitting(all));
    build_packed<QuantizedCodec<8, Scb2>>(mesh, fitting(packed));
    EXPECT_GT(packed.point_visits, 0u);
    EXPECT_LT(2 * packed.point_visits, all.point_visits);
}

TEST(PackedHierarchy, BuiltAtOnceRefusesWhatCannotBePacked) {
    Mesh mesh = height_field(3);
    mesh.vertices[4][0] = 1e9;
    EXPECT_THROW(build_packed<FloatCodec<8>>(mesh), InputError);
    mesh.vertices[4][0] = std::numeric_limits<double>::infinity();
    EXPECT_THROW(build_packed<FloatCodec<8>>(mesh), InputError);
}

TEST(PackedHierarchy, IsTheSameForAnyNumberOfThreads) {
    const Mesh mesh = height_field(100);  // more nodes than a thread takes at a time
    const BuiltMesh built(mesh);
    for_each_layout([&]<class Codec>(LayoutOf<Codec>, const char* name) {
        SCOPED_TRACE(name);
        const auto one = pack<Codec>(scb_of<typename Codec::Volume>(built), mesh, 1);
        const auto three = pack<Codec>(scb_of<typename Codec::Volume>(built), mesh, 1,
                                       LeafCorners::stored, "mesh", 3);
        expect_same(one, three);
    });
}

TEST(PackedHierarchy, TakesLessMemoryWithoutCorners) {
    const Mesh mesh = height_field(64);
    const auto hierarchy = build_hierarchy<Scb>(mesh);
    const auto bytes = [&](LeafCorners corners) {
        return static_cast<double>(pack<QuantizedCodec<8>>(hierarchy, mesh, 4, corners).bytes()) /
               static_cast<double>(mesh.triangles.size());
    };
    EXPECT_NEAR(bytes(LeafCorners::stored) - bytes(LeafCorners::in_mesh), 36, 1e-9);
    EXPECT_LT(bytes(LeafCorners::in_mesh), 40);
}

TEST(PackedHierarchy, QuantizedTakesLessMemory) {
    const Mesh mesh = height_field(64);
    const auto hierarchy = build_hierarchy<Scb>(mesh);
    EXPECT_LT(pack<QuantizedCodec<8>>(hierarchy, mesh).bytes(),
              pack<FloatCodec<8>>(hierarchy, mesh).bytes());
    const auto two_slabs = build_hierarchy<Scb2>(mesh);
    EXPECT_LT((pack<QuantizedCodec<8, Scb2>>(two_slabs, mesh).bytes()),
              (pack<FloatCodec<8, Scb2>>(two_slabs, mesh).bytes()));
    EXPECT_LT(pack<FloatCodec<8>>(hierarchy, mesh, 4).bytes(),
              pack<FloatCodec<8>>(hierarchy, mesh, 1).bytes());
}

}  // namespace
}  // namespace scb
