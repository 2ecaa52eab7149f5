#include "core/distance/contact_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/geometry/mesh_parts.h"
#include "core/geometry/triangle_segment.h"
#include "tests/core/collide/small_scenes.h"

namespace scb {
namespace {

using Numbers = std::vector<std::uint32_t>;

std::vector<ContactPatch> patches_of(const Mesh& a, const Mesh& b, const Pose& b_to_a,
                                     const std::vector<IndexPair>& pairs, bool is_self = false) {
    const std::vector<Triangle> of_a = joined_triangles(a), of_b = joined_triangles(b);
    return contact_patches({a, of_a}, {b, of_b}, b_to_a, pairs, is_self);
}

std::vector<IndexPair> intersecting(const Mesh& a, const Mesh& b, const Pose& b_to_a) {
    std::vector<IndexPair> pairs;
    for (std::uint32_t i = 0; i < a.triangles.size(); ++i)
        for (std::uint32_t j = 0; j < b.triangles.size(); ++j)
            if (triangles_overlap(corners(a, i), transform_corners(b_to_a, corners(b, j))))
                pairs.push_back({i, j});
    return pairs;
}

bool have_common_corner(const Mesh& mesh, std::uint32_t i, std::uint32_t j) {
    for (const Vec3& p : corners(mesh, i))
        for (const Vec3& q : corners(mesh, j))
            if (p == q) return true;
    return false;
}

/// The partition by comparing each pair with each, by the positions of corners.
std::set<Numbers> compared_one_by_one(const Mesh& a, const Mesh& b,
                                      const std::vector<IndexPair>& pairs, bool is_self) {
    std::vector<std::uint32_t> patch(pairs.size());
    for (std::uint32_t i = 0; i < pairs.size(); ++i) patch[i] = i;
    for (std::uint32_t i = 0; i < pairs.size(); ++i)
        for (std::uint32_t j = 0; j < i; ++j) {
            const IndexPair x = pairs[i], y = pairs[j];
            if (!(have_common_corner(a, x.a, y.a) && have_common_corner(b, x.b, y.b)) &&
                !(is_self && have_common_corner(a, x.a, y.b) && have_common_corner(a, x.b, y.a)))
                continue;
            const std::uint32_t from = patch[i], to = patch[j];
            std::replace(patch.begin(), patch.end(), from, to);
        }
    std::set<Numbers> sets;
    for (std::uint32_t number = 0; number < pairs.size(); ++number) {
        Numbers members;
        for (std::uint32_t i = 0; i < pairs.size(); ++i)
            if (patch[i] == number) members.push_back(i);
        if (!members.empty()) sets.insert(members);
    }
    return sets;
}

void expect_partition(const std::vector<ContactPatch>& patches, const std::set<Numbers>& expected) {
    std::set<Numbers> found;
    for (const ContactPatch& patch : patches) found.insert(patch.pairs);
    EXPECT_EQ(found, expected);
    EXPECT_TRUE(std::is_sorted(patches.begin(), patches.end(), [](const auto& x, const auto& y) {
        return x.pairs.size() > y.pairs.size() ||
               (x.pairs.size() == y.pairs.size() && x.pairs[0] < y.pairs[0]);
    }));
}

bool holds(const Box& box, const Vec3& p) {
    return (box.lower.array() <= p.array()).all() && (p.array() <= box.upper.array()).all();
}

TEST(ContactPatches, AreThePartitionByComparingAllPairs) {
    std::size_t several = 0;
    for (int seed = 0; seed < scenes_tried / 2; ++seed) {
        const SmallScene scene = small_scene(static_cast<std::uint64_t>(seed));
        const Mesh &a = scene.a.mesh, &b = scene.b.mesh;
        const std::vector<IndexPair> pairs = intersecting(a, b, scene.pose);
        const std::vector<ContactPatch> patches = patches_of(a, b, scene.pose, pairs);
        expect_partition(patches, compared_one_by_one(a, b, pairs, false));
        several += patches.size() > 1;
        for (const ContactPatch& patch : patches)
            for (const std::uint32_t i : patch.pairs) {
                const auto meet = triangles_intersection(
                    corners(a, pairs[i].a), transform_corners(scene.pose, corners(b, pairs[i].b)));
                ASSERT_TRUE(meet);
                EXPECT_TRUE(holds(patch.box, meet->a) && holds(patch.box, meet->b));
            }
    }
    EXPECT_GT(several, scenes_tried / 20u);
}

TEST(ContactPatches, OfOneBodyMayExchangeTheTrianglesOfAPair) {
    std::size_t exchanged = 0;
    for (int seed = 0; seed < scenes_tried / 2; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Mesh mesh = grid_soup(random, 30, 6);
        std::vector<IndexPair> pairs;
        for (const IndexPair& pair : intersecting(mesh, mesh, {}))
            if (pair.a < pair.b && !have_common_corner(mesh, pair.a, pair.b)) pairs.push_back(pair);
        const std::vector<ContactPatch> patches = patches_of(mesh, mesh, {}, pairs, true);
        expect_partition(patches, compared_one_by_one(mesh, mesh, pairs, true));
        exchanged += patches.size() != patches_of(mesh, mesh, {}, pairs).size();
    }
    EXPECT_GT(exchanged, scenes_tried / 50u);
}

/// A tetrahedron that stands on its tip.
void add_spike(Mesh& mesh, const Vec3& tip) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3& corner :
         {Vec3(0, 0, 0), Vec3(0.1, 0, 1), Vec3(-0.1, 0.1, 1), Vec3(0, -0.1, 1)})
        mesh.vertices.push_back(tip + corner);
    for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 1}})
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

Mesh floor_of_two(double size) {
    return {{{-size, -size, 0}, {size, -size, 0}, {size, size, 0}, {-size, size, 0}},
            {{0, 1, 2}, {0, 2, 3}}};
}

TEST(ContactPatches, OfAFloorOfTwoTrianglesAreSmall) {
    Mesh feet;
    for (const Vec3& tip : {Vec3(3, 1, -0.5), Vec3(-3, 1, -0.5), Vec3(3, -2, -0.5)})
        add_spike(feet, tip);
    for (const Vec3& place : {Vec3(0, 0, 0), Vec3(1e6, -1e6, 1e6)}) {
        Mesh ground = floor_of_two(1000);
        Pose pose;
        for (Vec3& v : ground.vertices) v += place;
        pose.translation = place;
        const std::vector<ContactPatch> patches =
            patches_of(ground, feet, pose, intersecting(ground, feet, pose));
        ASSERT_EQ(patches.size(), 3u);
        for (const ContactPatch& patch : patches)
            EXPECT_LT((patch.box.upper - patch.box.lower).maxCoeff(), 0.2);
    }
}

TEST(ContactPatches, OfFacesOnEachOtherHoldTheArea) {
    const Mesh large = floor_of_two(10), small = floor_of_two(1);
    const std::vector<ContactPatch> patches =
        patches_of(large, small, {}, intersecting(large, small, {}));
    ASSERT_EQ(patches.size(), 1u);
    EXPECT_EQ(patches[0].pairs.size(), 4u);
    EXPECT_EQ(patches[0].box.lower, Vec3(-1, -1, 0));
    EXPECT_EQ(patches[0].box.upper, Vec3(1, 1, 0));

    // The longest edge is at y = 0.
    const Mesh one{{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}}, {{0, 1, 2}}};
    const Box box = patches_of(large, one, {}, {{0, 0}})[0].box;
    EXPECT_LE(box.lower.norm(), 1e-15);
    EXPECT_LE((box.upper - Vec3(4, 1, 0)).norm(), 1e-15);
}

TEST(ContactPatches, OfASoupAreTheOnesOfTheMesh) {
    const Mesh mesh = height_field(12);
    Mesh soup, other = height_field(9);
    for (const Triangle& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const std::uint32_t v : t) soup.vertices.push_back(mesh.vertices[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    Random random(5);
    for (Vec3& v : other.vertices) v[2] += random.uniform(-0.05, 0.05);
    const std::vector<IndexPair> pairs = intersecting(mesh, other, {});
    const auto of_mesh = patches_of(mesh, other, {}, pairs),
               of_soup = patches_of(soup, other, {}, pairs);
    ASSERT_GT(of_mesh.size(), 0u);
    ASSERT_EQ(of_mesh.size(), of_soup.size());
    for (std::size_t i = 0; i < of_mesh.size(); ++i) {
        EXPECT_EQ(of_mesh[i].pairs, of_soup[i].pairs);
        EXPECT_EQ(of_mesh[i].box.upper, of_soup[i].box.upper);
    }
}

TEST(ContactPatches, OfNoPairsAreNone) {
    const Mesh mesh = floor_of_two(1);
    EXPECT_TRUE(patches_of(mesh, mesh, {}, {}).empty());
}

}  // namespace
}  // namespace scb
