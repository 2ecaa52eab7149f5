#include "core/distance/distance_certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/core/distance/proof_scene.h"

namespace scb {
namespace {

/// A sphere of n x 2n quads.
Mesh sphere(int n, double radius) {
    Mesh mesh;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j < 2 * n; ++j) {
            const double polar = M_PI * i / n, around = M_PI * j / n;
            mesh.vertices.push_back(radius * Vec3(std::sin(polar) * std::cos(around),
                                                  std::sin(polar) * std::sin(around),
                                                  std::cos(polar)));
        }
    const auto at = [n](int i, int j) {
        return static_cast<std::uint32_t>(i * 2 * n + j % (2 * n));
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < 2 * n; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

void make_needles(Mesh& mesh, Random& random) {
    for (const Triangle& t : mesh.triangles)
        mesh.vertices[t[2]] = mesh.vertices[t[0]] +
                              random.uniform(0, 1) * (mesh.vertices[t[1]] - mesh.vertices[t[0]]) +
                              std::pow(10, random.uniform(-12, -2)) * Vec3(0.3, -0.5, 0.7);
}

/// Meshes of many kinds: near each other, far, one in the other, touching, with needles, far from
/// the origin, large and small.
ProofScene proof_scene(std::uint64_t seed) {
    Random random(seed);
    const auto count = [&] { return 1 + static_cast<int>(random.below(30)); };
    Mesh a = small_mesh(random, count()), b = small_mesh(random, count());
    Pose pose = small_pose(random);
    switch (random.below(6)) {
        case 0:
            pose.translation += random_unit_vector(random) * std::pow(10, random.uniform(-3, 3));
            break;
        case 1:
            a = sphere(5, 3);
            b = sphere(4, random.uniform(0.1, 2.5));
            break;
        case 2:
            make_needles(a, random);
            make_needles(b, random);
            break;
        case 3: {  // nearly the same surface
            b = a;
            pose = {};
            pose.translation = random_unit_vector(random) * std::pow(10, random.uniform(-17, -1));
            break;
        }
        case 4:  // above each other
            for (Vec3& v : a.vertices) v[2] = std::min(v[2], 1.0);
            for (Vec3& v : b.vertices) v[2] = std::max(v[2], 1.0);
            pose = {};
            pose.translation[2] = random.below(2) == 0 ? 0 : std::pow(10, random.uniform(-17, 0));
            break;
        default:
            break;
    }
    if (random.below(4) == 0)
        for (Mesh* mesh : {&a, &b})
            for (Vec3& v : mesh->vertices) v += Vec3(1e4, -2e3, 3e4);
    const double scale = std::array<double, 4>{1, 1e-6, 1e6, 0.37}[random.below(4)];
    for (Mesh* mesh : {&a, &b})
        for (Vec3& v : mesh->vertices) v *= scale;
    pose.translation *= scale;
    return {a, b, pose};
}

TEST(DistanceCertificate, ProvesTheDistanceOfSmallMeshes) {
    int apart = 0, meeting = 0;
    double widest = 0;
    for (int i = 0; i < scenes_tried; ++i) {
        SCOPED_TRACE(i);
        const ProofScene scene = proof_scene(static_cast<std::uint64_t>(i));
        const BruteForce brute(scene);
        const DistanceCertificate certificate =
            make_certificate(scene.tree_a(), scene.tree_b(), scene.pose, brute.closest);
        const ProvenDistance proven = scene.check(certificate);
        ASSERT_EQ(proven.fault, "");
        ASSERT_LE(proven.lower, proven.upper);
        ASSERT_TRUE(holds(proven, brute.distance))
            << proven.lower << " " << static_cast<double>(brute.distance) << " " << proven.upper;
        ASSERT_TRUE(certifies(proven, brute.rounded))
            << width_share(proven, brute.rounded) << " " << brute.rounded;
        if (brute.rounded > 0) {
            widest = std::max(widest, width_share(proven, brute.rounded));
            ++apart;
        } else {
            EXPECT_EQ(proven.upper, 0);
            EXPECT_TRUE(certificate.cut.empty());
            ++meeting;
        }
    }
    RecordProperty("widest", std::to_string(widest));
    EXPECT_GT(apart, scenes_tried / 2);
    EXPECT_GT(meeting, scenes_tried / 10);
    EXPECT_GT(widest, unless_sanitized(0.05, 1e-6)) << "the width that is allowed is far too large";
}

TEST(DistanceCertificate, ProvesTheResultOfEveryVolume) {
    Random random(43);
    for (int i = 0; i < scenes_tried / 20; ++i) {
        SCOPED_TRACE(i);
        const BuiltMesh a(small_mesh(random, 25)), b(small_mesh(random, 25));
        Pose pose = small_pose(random);
        pose.translation += random_unit_vector(random) * std::pow(10, random.uniform(-1, 1));
        for (std::size_t kind = 0; kind < all_volume_kinds().size(); ++kind) {
            SCOPED_TRACE(volume_kind_name(all_volume_kinds()[kind]));
            std::visit(
                [&]<Volume V>(const Hierarchy<V>& of_a) {
                    const Collider<V> side_a{of_a, a.mesh},
                        side_b{std::get<Hierarchy<V>>(b.hierarchies[kind]), b.mesh};
                    const Distance found = distance(side_a, side_b, pose);
                    ASSERT_TRUE(found.triangles);
                    const ProvenDistance proven =
                        check_distance(mesh_tree(side_a), mesh_tree(side_b), pose,
                                       make_certificate(mesh_tree(side_a), mesh_tree(side_b), pose,
                                                        *found.triangles));
                    ASSERT_EQ(proven.fault, "");
                    EXPECT_TRUE(certifies(proven, found.found.distance));
                    EXPECT_FALSE(certifies(proven, found.found.distance * 1.001 + 1e-9));
                },
                a.hierarchies[kind]);
        }
    }
}

TEST(DistanceCertificate, IsSmallWhereMeshesAreConvex) {
    const ProofScene apart(sphere(10, 1), sphere(10, 1), {Mat3::Identity(), {5, 1, 2}});
    const BruteForce brute(apart);
    const DistanceCertificate certificate =
        make_certificate(apart.tree_a(), apart.tree_b(), apart.pose, brute.closest);
    EXPECT_EQ(certificate.directions.size(), 1u);
    EXPECT_TRUE(certifies(apart.check(certificate), brute.rounded));
}

ProvenDistance proven_of(const TriangleCorners& a, const TriangleCorners& b) {
    const auto mesh = [](const TriangleCorners& t) {
        return Mesh{{t[0], t[1], t[2]}, {{0, 1, 2}}};
    };
    const ProofScene scene(mesh(a), mesh(b), {});
    return scene.check(make_certificate(scene.tree_a(), scene.tree_b(), {}, {0, 0}));
}

TEST(DistanceCertificate, IsNarrowForNeedlesWhoseHeightIsRounding) {
    // A corner above the face of a needle, whose normal even double-doubles cannot tell.
    const TriangleCorners
        needle = {Vec3(0.25103718143418607, -0.26036596867777373, 0.38355441323039763),
                  Vec3(-0.57140141438928294, 0.51266528939044953, -0.003155269039711861),
                  Vec3(-0.11410634847643182, 0.082841857092678842, 0.21186434524016712)},
        other = {Vec3(-0.42713230234595545, 0.37706302832246791, 0.064679901589416763),
                 Vec3(-0.34827844136508568, 0.31342568129341081, 0.036051070060242565),
                 Vec3(-0.22713230234595566, 0.27706302832246765, 0.36467990158941666)};
    // Another one, in which the point below the corner is the difficulty.
    const TriangleCorners
        thin = {Vec3(-0.016414386087520993, 0.6380111778139439, 0.78325329069802896),
                Vec3(-0.70325340405039305, -0.83443085154528274, -0.45362898318628053),
                Vec3(-0.54921855584895063, -0.5042117193380431, -0.17623796677910908)},
        above = {Vec3(-0.50497294681047245, -0.40935820540099205, -0.096559020059941589),
                 Vec3(-0.45623761239554422, -0.40248695054610412, -0.014704389105782284),
                 Vec3(-0.30497294681047243, -0.50935820540099208, 0.20344097994005839)};
    // Edges that lie on each other, up to rounding.
    const TriangleCorners
        lying = {Vec3(-0.4596203084890198, 0.647437913943268, -0.80646551402091293),
                 Vec3(0.8421029174890049, -0.92593397916785047, -0.56510381525899889),
                 Vec3(-0.36536576325307518, 0.53351396351149682, -0.78898911297023111)},
        moved = {Vec3(0.84210291748900479, -0.92593397916785036, -0.56510381525899878),
                 Vec3(-0.36536576325307535, 0.53351396351149694, -0.788989112970231),
                 Vec3(-0.45962030848901997, 0.64743791394326811, -0.80646551402091282)};
    for (const auto& [a, b] :
         {std::pair(needle, other), std::pair(thin, above), std::pair(lying, moved)})
        for (const bool is_swapped : {false, true}) {
            const ProvenDistance proven = is_swapped ? proven_of(b, a) : proven_of(a, b);
            EXPECT_TRUE(holds(proven, distance_oracle::distance(a, b)));
            EXPECT_LE(width_share(proven, proven.upper), 0.5);
        }
}

TEST(DistanceCertificate, HoldsForExtremeNumbers) {
    // A gap whose square is no double, and one that doubles cannot hold beside the coordinates.
    for (const double gap : {1e-200, 1e-20, 5e-324}) {
        const ProofScene scene({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}},
                               {{{1, 1, gap}, {1, 1, 5}, {2, 1, 5}}, {{0, 1, 2}}}, {});
        const ProvenDistance proven =
            scene.check(make_certificate(scene.tree_a(), scene.tree_b(), {}, {0, 0}));
        EXPECT_LE(proven.lower, gap);
        EXPECT_GE(proven.upper, gap);
        EXPECT_TRUE(certifies(proven, gap));
    }
    for (const double size : {1e-60, 1e70}) {
        Mesh a = random_soup(1, 20, 0.1), b = random_soup(2, 20, 0.1);
        for (Mesh* mesh : {&a, &b})
            for (Vec3& v : mesh->vertices) v *= size / 2;
        const ProofScene scene(a, b, {Mat3::Identity(), {0.3 * size, 0.1 * size, 0.2 * size}});
        const BruteForce brute(scene);
        ASSERT_GT(brute.rounded, 0);
        const ProvenDistance proven = scene.check(
            make_certificate(scene.tree_a(), scene.tree_b(), scene.pose, brute.closest));
        EXPECT_TRUE(holds(proven, brute.distance));
        EXPECT_TRUE(certifies(proven, brute.rounded));
    }
}

}  // namespace
}  // namespace scb
