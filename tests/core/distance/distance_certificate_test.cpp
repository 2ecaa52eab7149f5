#include "core/distance/distance_certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/core/collide/small_scenes.h"
#include "tests/core/geometry/distance_oracle.h"

namespace scb {
namespace {

/// Two meshes with one tree each.
struct ProofScene {
    Mesh a, b;
    Pose pose;
    Topology of_a, of_b;

    ProofScene(const Mesh& mesh_a, const Mesh& mesh_b, const Pose& b_to_a)
        : a(mesh_a),
          b(mesh_b),
          pose(b_to_a),
          of_a(build_topology(a)),
          of_b(build_topology(b, {.split = SplitMethod::cost})) {}
    MeshTree tree_a() const { return {a, of_a}; }
    MeshTree tree_b() const { return {b, of_b}; }
    TriangleCorners corners_a(std::uint32_t i) const { return corners(a, i); }
    TriangleCorners corners_b(std::uint32_t j) const {
        return transform_corners(pose, corners(b, j));
    }
    ProvenDistance check(const DistanceCertificate& certificate) const {
        return check_distance(tree_a(), tree_b(), pose, certificate);
    }
};

/// The closest triangles, and their distance in higher precision: of all pairs that are about as
/// close as the closest.
struct BruteForce {
    IndexPair closest;
    double rounded = HUGE_VAL;
    long double distance = HUGE_VALL;

    explicit BruteForce(const ProofScene& scene) {
        std::vector<std::pair<double, IndexPair>> all;
        for (std::uint32_t i = 0; i < scene.a.triangles.size(); ++i)
            for (std::uint32_t j = 0; j < scene.b.triangles.size(); ++j)
                all.emplace_back(triangle_distance(scene.corners_a(i), scene.corners_b(j)).distance,
                                 IndexPair{i, j});
        std::sort(all.begin(), all.end());
        rounded = all.front().first;
        closest = all.front().second;
        double largest = 0;
        for (std::uint32_t j = 0; j < scene.b.triangles.size(); ++j)
            for (const Vec3& p : scene.corners_b(j)) largest = std::max(largest, p.norm());
        int measured = 0;
        for (const auto& [found, pair] : all) {
            if (found > rounded * (1 + 1e-9) + 1e-14 * largest || ++measured > 20) break;
            distance = std::min(distance, distance_oracle::distance(scene.corners_a(pair.a),
                                                                    scene.corners_b(pair.b)));
        }
    }
};

/// Whether the bounds hold a distance, up to the rounding of the oracle.
bool holds(const ProvenDistance& proven, long double distance) {
    const long double slack =
        1e-18L * static_cast<long double>(proven.largest_coordinate) + 1e-17L * distance;
    return static_cast<long double>(proven.lower) <= distance + slack &&
           static_cast<long double>(proven.upper) >= distance - slack;
}

double width_share(const ProvenDistance& proven, double distance) {
    return (proven.upper - proven.lower) / allowed_width(distance, proven.largest_coordinate);
}

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

/// A scene whose cut has many ends, with its certificate.
struct TamperedScene {
    ProofScene scene;
    BruteForce brute;
    DistanceCertificate certificate;

    explicit TamperedScene(std::uint64_t seed)
        : scene(random_soup(seed, 40, 0.1), random_soup(seed + 1, 40, 0.1),
                {Mat3::Identity(), {0.3, 0.1, 0.2}}),
          brute(scene),
          certificate(make_certificate(scene.tree_a(), scene.tree_b(), scene.pose, brute.closest)) {
    }
};

TEST(DistanceCertificate, ProvesNothingUntrueOnceTampered) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    using Tamper = std::function<void(DistanceCertificate&, Random&)>;
    const auto some_direction = [](DistanceCertificate& c, Random& random) -> Vec3& {
        return c.directions[random.below(static_cast<std::uint32_t>(c.directions.size()))];
    };
    const auto some_step = [](DistanceCertificate& c, Random& random) -> CutStep& {
        return c.cut[random.below(static_cast<std::uint32_t>(c.cut.size()))];
    };
    struct Kind {
        const char* name;
        bool is_fault;  // always; otherwise a fault or wide bounds
        Tamper tamper;
    };
    const std::vector<Kind> kinds = {
        {"the last pair left out", true,
         [](auto& c, auto&) {
             c.cut.pop_back();
             c.directions.pop_back();
         }},
        {"a pair left out", true,
         [](auto& c, auto& random) {
             const auto at = random.below(static_cast<std::uint32_t>(c.directions.size()));
             std::uint32_t ends = 0;
             for (std::size_t i = 0; i < c.cut.size(); ++i)
                 if (c.cut[i] == CutStep::end && ends++ == at) {
                     c.cut.erase(c.cut.begin() + static_cast<std::ptrdiff_t>(i));
                     break;
                 }
             c.directions.erase(c.directions.begin() + at);
         }},
        {"truncated", true,
         [](auto& c, auto& random) {
             c.cut.resize(1 + random.below(static_cast<std::uint32_t>(c.cut.size() - 1)));
         }},
        {"steps after the end", true,
         [](auto& c, auto&) {
             c.cut.push_back(CutStep::end);
             c.directions.push_back(Vec3::UnitX());
         }},
        {"divisions after the end", true,
         [](auto& c, auto&) { c.cut.push_back(CutStep::divide_a); }},
        {"a direction too many", true,
         [](auto& c, auto&) { c.directions.push_back(Vec3::UnitX()); }},
        {"a direction too few", true, [](auto& c, auto&) { c.directions.pop_back(); }},
        {"an unknown step", true,
         [&](auto& c, auto& random) { some_step(c, random) = static_cast<CutStep>(77); }},
        {"leaves divided", true, [](auto& c, auto&) { c.cut.assign(1000, CutStep::divide_a); }},
        {"a step changed", true,
         [&](auto& c, auto& random) {
             CutStep& step = some_step(c, random);
             step = step == CutStep::end ? CutStep::divide_b : CutStep::end;
         }},
        {"a triangle out of range", true, [](auto& c, auto&) { c.on_a.triangle = 40; }},
        {"a triangle far out of range", true, [](auto& c, auto&) { c.on_b.triangle = ~0u; }},
        {"a corner out of range", true, [](auto& c, auto&) { c.on_b.corner = 3; }},
        {"a point outside", true, [](auto& c, auto&) { c.on_a.to_next = -1e-9; }},
        {"a point beyond", true, [](auto& c, auto&) { c.on_a.to_after = 0.7; }},
        {"a point that is none", true, [&](auto& c, auto&) { c.on_b.to_after = nan; }},
        {"another triangle", false,
         [](auto& c, auto&) { c.on_a.triangle = (c.on_a.triangle + 7) % 40; }},
        {"another point", false, [](auto& c, auto&) { c.on_a.to_next = 0.5 - c.on_a.to_next; }},
        {"a direction flipped", false,
         [&](auto& c, auto& random) { some_direction(c, random) *= -1; }},
        {"a direction that is none", false,
         [&](auto& c, auto& random) { some_direction(c, random)[1] = nan; }},
        {"an infinite direction", false,
         [&](auto& c, auto& random) { some_direction(c, random)[0] = HUGE_VAL; }},
        {"no direction", false,
         [&](auto& c, auto& random) { some_direction(c, random).setZero(); }},
        {"directions in another order", false,
         [](auto& c, auto&) { std::reverse(c.directions.begin(), c.directions.end()); }},
        {"the roots alone", false,
         [](auto& c, auto&) {
             c.cut = {CutStep::end};
             c.directions = {Vec3::UnitX()};
         }},
        {"no cut", false,
         [](auto& c, auto&) {
             c.cut.clear();
             c.directions.clear();
         }},
    };
    int tampered_with = 0;
    for (int i = 0; i < unless_sanitized(40, 4); ++i) {
        const TamperedScene honest(static_cast<std::uint64_t>(2 * i));
        if (honest.brute.rounded == 0) continue;
        ++tampered_with;
        ASSERT_GT(honest.certificate.directions.size(), 2u);
        ASSERT_TRUE(certifies(honest.scene.check(honest.certificate), honest.brute.rounded));
        Random random(static_cast<std::uint64_t>(i));
        for (const Kind& kind : kinds) {
            SCOPED_TRACE(kind.name);
            DistanceCertificate tampered = honest.certificate;
            kind.tamper(tampered, random);
            const ProvenDistance proven = honest.scene.check(tampered);
            EXPECT_TRUE(holds(proven, honest.brute.distance));
            EXPECT_FALSE(certifies(proven, honest.brute.rounded));
            EXPECT_EQ(!proven.fault.empty(), kind.is_fault) << proven.fault;
        }
    }
    EXPECT_GT(tampered_with, unless_sanitized(10, 0));
}

TEST(DistanceCertificate, ProvesNothingUntrueByRandomLists) {
    const TamperedScene honest(4);
    Random random(29);
    int proofs = 0;
    for (int i = 0; i < 20'000 / unless_sanitized(1, 10); ++i) {
        ProofScene scene = honest.scene;
        const std::uint32_t spoiled = random.below(4);
        for (std::uint32_t k = 0; k < spoiled; ++k) {
            Topology& tree = random.below(2) == 0 ? scene.of_a : scene.of_b;
            TopologyNode& node =
                tree.nodes[random.below(static_cast<std::uint32_t>(tree.nodes.size()))];
            const std::array<std::uint32_t*, 3> numbers = {&node.first, &node.count, &node.left};
            *numbers[random.below(3)] =
                random.below(8) == 0 ? static_cast<std::uint32_t>(random.next()) : random.below(80);
        }
        // A list that ends where all pairs have ended, most of the time.
        DistanceCertificate certificate = honest.certificate;
        certificate.cut.clear();
        certificate.directions.clear();
        for (std::uint32_t open = 1; open > 0 && certificate.cut.size() < 200;) {
            const std::uint32_t kind = random.below(100);
            const CutStep step = kind < 53   ? CutStep::end
                                 : kind < 76 ? CutStep::divide_a
                                             : CutStep::divide_b;
            certificate.cut.push_back(step);
            if (step == CutStep::end) certificate.directions.push_back(random_point(random));
            open = step == CutStep::end ? open - 1 : open + 1;
        }
        const ProvenDistance proven = scene.check(certificate);
        proofs += proven.fault.empty();
        ASSERT_TRUE(holds(proven, honest.brute.distance)) << i;
    }
    EXPECT_GT(proofs, 1000 / unless_sanitized(1, 10));
}

TEST(DistanceCertificate, HoldsForDirectionsOfAnyLength) {
    for (const double scale : {1e-300, 1e-12, 3.0, 1e290}) {
        TamperedScene honest(8);
        for (Vec3& direction : honest.certificate.directions) direction *= scale / direction.norm();
        EXPECT_TRUE(certifies(honest.scene.check(honest.certificate), honest.brute.rounded));
    }
}

TEST(DistanceCertificate, IsForItsMeshesAndItsPose) {
    for (int i = 0; i < unless_sanitized(40, 4); ++i) {
        const TamperedScene honest(static_cast<std::uint64_t>(2 * i));
        if (honest.brute.rounded == 0) continue;
        ProofScene moved = honest.scene;
        moved.pose.translation += Vec3(0.1, -0.2, 0.1);
        Random random(static_cast<std::uint64_t>(i));
        ProofScene turned = honest.scene;
        turned.pose.rotation = random_rotation(random);
        const ProofScene swapped(honest.scene.b, honest.scene.a, inverse(honest.scene.pose)),
            other(honest.scene.a, random_soup(99, 40, 0.1), honest.scene.pose),
            smaller(honest.scene.a, random_soup(99, 9, 0.1), honest.scene.pose);
        for (const ProofScene& scene : {moved, turned, swapped, other, smaller}) {
            const BruteForce brute(scene);
            const ProvenDistance proven = scene.check(honest.certificate);
            EXPECT_TRUE(holds(proven, brute.distance));
            EXPECT_FALSE(certifies(proven, brute.rounded));
        }
        ProofScene scaled = honest.scene;
        scaled.pose.rotation *= 2;  // not rigid, but a map of B's corners
        EXPECT_TRUE(holds(scaled.check(honest.certificate), BruteForce(scaled).distance));
        scaled.pose.rotation(1, 1) = std::numeric_limits<double>::quiet_NaN();
        EXPECT_NE(scaled.check(honest.certificate).fault, "");
    }
}

/// Divides all of A's tree, and none of B's nodes.
DistanceCertificate divided_a(const ProofScene& scene) {
    DistanceCertificate certificate;
    std::vector<std::uint32_t> pending = {0};
    while (!pending.empty()) {
        const TopologyNode& node = scene.of_a.nodes[pending.back()];
        pending.pop_back();
        certificate.cut.push_back(node.is_leaf() ? CutStep::end : CutStep::divide_a);
        if (node.is_leaf())
            certificate.directions.push_back(Vec3::UnitX());
        else
            pending.insert(pending.end(), {node.left + 1, node.left});
    }
    return certificate;
}

TEST(DistanceCertificate, NeedsChildrenThatMakeUpTheirParents) {
    const TamperedScene honest(4);
    const DistanceCertificate divided = divided_a(honest.scene);
    EXPECT_EQ(honest.scene.check(divided).fault, "");
    for (const TopologyNode& node : honest.scene.of_a.nodes) {
        if (node.is_leaf()) continue;
        ProofScene shifted = honest.scene;
        ++shifted.of_a.nodes[node.left].first;
        ++shifted.of_a.nodes[node.left + 1].first;
        EXPECT_NE(shifted.check(divided).fault, "");
        for (const bool is_right : {false, true})
            for (const std::uint32_t change : {1u, ~0u}) {
                ProofScene scene = honest.scene;
                TopologyNode& child = scene.of_a.nodes[node.left + is_right];
                child.first += change;
                EXPECT_NE(scene.check(divided).fault, "");
                child.first -= change;
                child.count += change;
                EXPECT_NE(scene.check(divided).fault, "");
            }
    }
}

TEST(DistanceCertificate, NeedsTreesThatHaveAllTriangles) {
    const TamperedScene honest(4);
    const auto fault = [&](const std::function<void(ProofScene&)>& spoil) {
        ProofScene scene = honest.scene;
        spoil(scene);
        return scene.check(honest.certificate).fault;
    };
    EXPECT_EQ(fault([](auto&) {}), "");
    EXPECT_NE(fault([](auto& s) { s.of_a.order[3] = s.of_a.order[4]; }), "");
    EXPECT_NE(fault([](auto& s) { s.of_b.order[3] = 40; }), "");
    EXPECT_NE(fault([](auto& s) { s.of_a.order.pop_back(); }), "");
    EXPECT_NE(fault([](auto& s) { s.of_a.nodes.clear(); }), "");
    EXPECT_NE(fault([](auto& s) { s.of_b.nodes[0].count = 39; }), "");
    EXPECT_NE(fault([](auto& s) { s.of_a.nodes[0].left = 79; }), "");
    EXPECT_NE(fault([](auto& s) { s.of_a.nodes[0].left = ~0u; }), "");
    EXPECT_NE(fault([](auto& s) { --s.of_a.nodes[s.of_a.nodes[0].left].count; }), "");
    EXPECT_NE(fault([](auto& s) { ++s.of_b.nodes[s.of_b.nodes[0].left + 1].first; }), "");
    EXPECT_NE(fault([](auto& s) { s.a.triangles.clear(); }), "");
    EXPECT_NE(fault([](auto& s) { s.a.triangles[5][1] = 4000; }), "");
    EXPECT_NE(fault([](auto& s) { s.b.vertices[5][1] = HUGE_VAL; }), "");
    // A node that is its own child: a cut ends with its list.
    ProofScene loop = honest.scene;
    loop.of_a.nodes[1] = loop.of_a.nodes[0];
    loop.of_a.nodes[2] = {40, 0, 0};
    loop.of_a.nodes[0].left = loop.of_a.nodes[1].left = 1;
    DistanceCertificate endless = honest.certificate;
    endless.cut.assign(100'000, CutStep::divide_a);
    EXPECT_NE(loop.check(endless).fault, "");
}

/// Two clouds along a line, whose gap is of the size of rounding, or larger, or an overlap.
TEST(DistanceCertificate, ProvesNoGapThatIsWiderThanThePointsAre) {
    Random random(71);
    double worst = 0;
    int positive = 0;
    for (int i = 0; i < 20'000 / unless_sanitized(1, 20); ++i) {
        const Vec3 n = random_unit_vector(random) * std::pow(10, random.uniform(-5, 5));
        const double far = std::pow(10, random.uniform(-3, 6)),
                     gap = std::pow(10, random.uniform(-17, 0)) * far;
        const Vec3 there = far * random_point(random);
        std::vector<Vec3> a, b;
        double of_a = 0, of_b = 0;
        const auto add = [&](std::vector<Vec3>& to, double& most, double height) {
            const Vec3 u = random_point(random), unit = n / n.norm();
            to.push_back(there + far * cross(unit, u) + height * unit);
            most = std::max(most, to.back().cwiseAbs().sum());
        };
        for (int k = 0; k < 6; ++k) add(a, of_a, random.below(2) == 0 ? 0 : -gap);
        for (int k = 0; k < 6; ++k) add(b, of_b, random.below(2) == 0 ? gap : 2 * gap);
        long double exact = HUGE_VALL;
        const auto at = [&](const Vec3& p, int axis) {
            return static_cast<long double>(n[axis]) * static_cast<long double>(p[axis]);
        };
        for (const Vec3& p : a)
            for (const Vec3& q : b)
                exact = std::min(
                    exact, (at(q, 0) - at(p, 0)) + (at(q, 1) - at(p, 1)) + (at(q, 2) - at(p, 2)));
        const auto x = static_cast<long double>(n[0]), y = static_cast<long double>(n[1]),
                   z = static_cast<long double>(n[2]);
        exact /= std::sqrt(x * x + y * y + z * z);
        const double magnitude = of_a + of_b, error = 1e-18 * magnitude;
        for (const double enough : {0.0, static_cast<double>(exact), HUGE_VAL}) {
            const double proven = proven_gap(a, b, n, magnitude, enough);
            ASSERT_LE(proven, std::max(exact, 0.0L) + static_cast<long double>(error)) << i;
            ASSERT_GE(proven, 0);
        }
        positive += exact > 0;
        // To the last bits, if they decide.
        worst = std::max(worst, static_cast<double>(exact) -
                                    proven_gap(a, b, n, magnitude, static_cast<double>(exact)) -
                                    error - 1e-14 * static_cast<double>(exact));
    }
    EXPECT_LE(worst, 0);
    EXPECT_GT(positive, 10'000 / unless_sanitized(1, 20));
}

TEST(DistanceCertificate, OfTrianglesThatAreNotTheClosestIsTrueAndWide) {
    std::size_t most_ends = 0;
    for (int i = 0; i < unless_sanitized(100, 5); ++i) {
        const TamperedScene honest(static_cast<std::uint64_t>(2 * i));
        const auto& scene = honest.scene;
        Random random(static_cast<std::uint64_t>(i));
        const IndexPair pair{random.below(40), random.below(40)};
        if (triangle_distance(scene.corners_a(pair.a), scene.corners_b(pair.b)).distance <=
            1.01 * honest.brute.rounded)
            continue;
        const DistanceCertificate certificate =
            make_certificate(scene.tree_a(), scene.tree_b(), scene.pose, pair);
        most_ends = std::max(most_ends, certificate.directions.size());
        const ProvenDistance proven = scene.check(certificate);
        EXPECT_EQ(proven.fault, "");
        EXPECT_TRUE(holds(proven, honest.brute.distance));
        EXPECT_NEAR(proven.lower, honest.brute.rounded, 1e-9);
        EXPECT_FALSE(certifies(proven, honest.brute.rounded));
    }
    // Of 1600 pairs of triangles: one pair that is too near is enough to give up the others.
    EXPECT_LT(most_ends, 400u);
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
