#include "scb/packed_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/packed/near_search.h"
#include "core/packed/query_sides.h"
#include "core/packed/shared_corners.h"
#include "scb/any_packed.h"
#include "scb/error.h"
#include "tests/core/collide/small_scenes.h"
#include "tests/core/packed/packed_variants.h"

namespace scb {
namespace {

constexpr DistanceOrder orders_of_queries[] = {DistanceOrder::nearest, DistanceOrder::depth_first,
                                               DistanceOrder::hybrid};
constexpr std::pair<int, LeafCorners> leaves_tried[] = {
    {1, LeafCorners::stored},
    {most_leaf_triangles, LeafCorners::stored},
    {most_leaf_triangles, LeafCorners::in_mesh}};

/// Calls `use` with two packed hierarchies, as colliders, and the reference hierarchies.
template <class Use>
void for_each_packed(const BuiltMesh& a, const BuiltMesh& b, const Use& use) {
    for_each_layout([&]<class Codec>(LayoutOf<Codec>, const char* name) {
        SCOPED_TRACE(name);
        using V = typename Codec::Volume;
        const Hierarchy<V>&of_a = scb_of<V>(a), &of_b = scb_of<V>(b);
        for (const auto& [leaf, corners] : leaves_tried) {
            const auto packed_a = pack<Codec>(of_a, a.mesh, leaf, corners),
                       packed_b = pack<Codec>(of_b, b.mesh, leaf, corners);
            use(PackedCollider<Codec>{packed_a, a.mesh}, PackedCollider<Codec>{packed_b, b.mesh},
                Collider<V>{of_a, a.mesh}, Collider<V>{of_b, b.mesh});
        }
    });
}

/// The same bits as the reference found; of distance 0, some triangles that intersect.
void expect_same_answer(const PackedDistance& found, const Distance& expected, const Mesh& a,
                        const Mesh& b, const Pose& b_to_a) {
    EXPECT_EQ(found.found.distance, expected.found.distance);
    ASSERT_EQ(found.triangles.has_value(), expected.triangles.has_value());
    if (!found.triangles) return;
    const TriangleDistance there = triangle_distance(
        corners(a, found.triangles->a), transform_corners(b_to_a, corners(b, found.triangles->b)));
    EXPECT_EQ(there.distance, expected.found.distance);
    EXPECT_EQ(found.found.point_a, there.point_a);
    EXPECT_EQ(found.found.point_b, there.point_b);
    if (expected.found.distance > 0) {
        EXPECT_EQ(found.triangles, expected.triangles);
    }
}

void expect_same_work(const PackedDistance& x, const PackedDistance& y) {
    EXPECT_EQ(x.found.distance, y.found.distance);
    EXPECT_EQ(x.triangles, y.triangles);
    EXPECT_EQ(x.n_v, y.n_v);
    EXPECT_EQ(x.n_bounded, y.n_bounded);
    EXPECT_EQ(x.n_p, y.n_p);
}

/// Every layout, order and level finds what the reference finds.
void expect_reference_distance(const BuiltMesh& a, const BuiltMesh& b, const Pose& pose) {
    for_each_packed(
        a, b, [&](const auto& packed_a, const auto& packed_b, const auto& of_a, const auto& of_b) {
            const Distance expected = distance(of_a, of_b, pose);
            for (const DistanceOrder order : orders_of_queries) {
                SCOPED_TRACE(distance_order_name(order));
                const DistanceOptions options{.order = order, .heap = 5};
                const PackedDistance best = distance_packed(packed_a, packed_b, pose, options);
                expect_same_answer(best, expected, a.mesh, b.mesh, pose);
                for (const SimdLevel level : available_simd_levels()) {
                    SCOPED_TRACE(simd_level_name(level));
                    expect_same_work(distance_packed(packed_a, packed_b, pose, options, level),
                                     best);
                }
            }
        });
}

/// Near, touching, nested and far poses.
Pose pose_of_query(Random& random) {
    Pose pose = random.below(3) == 0 ? exact_pose(random) : random_pose(random);
    const double apart = random.below(4) == 0 ? 0 : std::pow(10, random.uniform(-2, 1.5));
    pose.translation += Vec3(apart, 0.3 * apart, -0.2 * apart);
    return pose;
}

TEST(DistancePacked, IsThatOfTheReference) {
    Random random(51);
    for (int i = 0; i < scenes_tried / 10; ++i) {
        SCOPED_TRACE(i);
        const auto count = [&] { return 1 + static_cast<int>(random.below(60)); };
        const BuiltMesh a(small_mesh(random, count())), b(small_mesh(random, count()));
        expect_reference_distance(a, b, pose_of_query(random));
        if (HasFailure()) return;
    }
}

TEST(DistancePacked, IsThatOfTheReferenceFarFromTheOriginAndAtAnyScale) {
    Random random(52);
    for (int i = 0; i < scenes_tried / 25; ++i) {
        SCOPED_TRACE(i);
        const double scale = std::array{1.0, 1e-6, 1e6}[random.below(3)];
        const Vec3 away =
            random.below(2) == 0 ? Vec3(scale * 1e2 * random_point(random)) : Vec3(Vec3::Zero());
        Mesh a = random_soup(random.next(), 30, 0.3), b = random_soup(random.next(), 30, 0.3);
        Pose pose = pose_of_query(random);
        for (Vec3& v : a.vertices) v *= scale;
        for (Vec3& v : b.vertices) v = scale * v + away;
        pose.translation = scale * pose.translation - rotate(pose.rotation, away);
        expect_reference_distance(BuiltMesh(a), BuiltMesh(b), pose);
        if (HasFailure()) return;
    }
}

// Surfaces whose closest points are shared by many triangles: flat ones on each other, with gaps
// down to rounding and below, and a needle above a plate.
TEST(DistancePacked, IsThatOfTheReferenceWhereManyTrianglesAreEquallyNear) {
    Random random(53);
    for (int i = 0; i < scenes_tried / 50; ++i) {
        SCOPED_TRACE(i);
        Mesh plate = height_field(6), other = height_field(6);
        if (random.below(2) == 0)
            for (Vec3& v : plate.vertices) v[2] = 0;
        if (random.below(2) == 0)
            for (Vec3& v : other.vertices) v[2] = 0;
        Pose pose = random.below(2) == 0 ? Pose{} : Pose{random_rotation(random), Vec3::Zero()};
        pose.translation[2] += std::pow(10, random.uniform(random.below(2) == 0 ? -15 : -40, 0));
        expect_reference_distance(BuiltMesh(plate), BuiltMesh(other), pose);
        Mesh needle;
        for (int k = 0; k < 9; ++k) needle.vertices.emplace_back(k % 2 ? 1e-6 : 0, 0, 0.5 * k);
        for (std::uint32_t k = 0; k < 7; ++k) needle.triangles.push_back({k, k + 1, k + 2});
        expect_reference_distance(BuiltMesh(plate), BuiltMesh(needle), pose);
        if (HasFailure()) return;
    }
}

TEST(DistancePacked, EndsEarlyAsItsOptionsSay) {
    Random random(54);
    for (int i = 0; i < scenes_tried / 40; ++i) {
        SCOPED_TRACE(i);
        const BuiltMesh a(small_mesh(random, 30)), b(small_mesh(random, 30));
        const Pose pose = pose_of_query(random);
        for_each_packed(
            a, b,
            [&](const auto& packed_a, const auto& packed_b, const auto& of_a, const auto& of_b) {
                const Distance expected = distance(of_a, of_b, pose);
                const double least = expected.found.distance;
                for (const DistanceOrder order : orders_of_queries) {
                    const auto found = [&](DistanceOptions options) {
                        options.order = order;
                        return distance_packed(packed_a, packed_b, pose, options);
                    };
                    EXPECT_EQ(found({.enough = least * 0.9}).found.distance, least);
                    const PackedDistance near = found({.enough = 2 * least});
                    EXPECT_LE(near.found.distance, 2 * least);
                    EXPECT_LE(near.n_v, found({}).n_v);
                    EXPECT_LE(found({.relative_error = 0.5}).found.distance, 1.5 * least);
                    EXPECT_EQ(found({.relative_error = 0.5, .limit = least}).found.distance, least);
                    EXPECT_EQ(found({.limit = least}).found.distance, least);
                    if (least == 0) continue;
                    const PackedDistance beyond = found({.limit = least * 0.9});
                    EXPECT_FALSE(beyond.triangles);
                    EXPECT_EQ(beyond.found.distance, HUGE_VAL);
                    const IndexPair last = {
                        static_cast<std::uint32_t>(a.mesh.triangles.size() - 1),
                        static_cast<std::uint32_t>(b.mesh.triangles.size() - 1)};
                    for (const IndexPair seed : {*expected.triangles, last})
                        expect_same_answer(found({.seed = seed}), expected, a.mesh, b.mesh, pose);
                    EXPECT_LE(found({.seed = expected.triangles}).n_v, found({}).n_v);
                }
            });
        if (HasFailure()) return;
    }
}

TEST(WithinPacked, FindsWhatTheReferenceFinds) {
    Random random(55);
    std::uint64_t pairs = 0, in_doubles = 0;
    for (int i = 0; i < std::max(4, scenes_tried / 100); ++i) {
        SCOPED_TRACE(i);
        const BuiltMesh a(small_mesh(random, 40)), b(small_mesh(random, 40));
        const Pose pose = pose_of_query(random);
        for_each_packed(
            a, b,
            [&](const auto& packed_a, const auto& packed_b, const auto& of_a, const auto& of_b) {
                const double least = distance(of_a, of_b, pose).found.distance;
                for (const double tolerance : {0.0, 0.1, least, 2 * least}) {
                    const Collision expected = within(of_a, of_b, pose, tolerance);
                    const PackedWithin best = within_packed(packed_a, packed_b, pose, tolerance);
                    EXPECT_EQ(best.pairs, expected.pairs);
                    pairs += best.pairs.size();
                    in_doubles += best.n_p;
                    for (const SimdLevel level : available_simd_levels()) {
                        const PackedWithin same =
                            within_packed(packed_a, packed_b, pose, tolerance, level);
                        EXPECT_EQ(same.pairs, best.pairs);
                        EXPECT_EQ(same.n_v, best.n_v);
                        EXPECT_EQ(same.n_bounded, best.n_bounded);
                        EXPECT_EQ(same.n_p, best.n_p);
                    }
                }
            });
        if (HasFailure()) return;
    }
    EXPECT_GT(pairs, 0u);
    EXPECT_GT(in_doubles, 0u);
}

// All pairs of triangles of two small meshes, since none are beyond an infinite limit.
TEST(NearSearch, BoundsTheDistanceOfEveryPairOfTriangles) {
    using Codec = QuantizedCodec<4>;
    Random random(56);
    int close = 0, all = 0;
    for (int i = 0; i < scenes_tried; ++i) {
        SCOPED_TRACE(i);
        const double scale = std::array{1.0, 1e-6, 1e6}[random.below(3)];
        Mesh a = small_mesh(random, 12), b = small_mesh(random, 12);
        if (random.below(4) == 0)
            for (Mesh* mesh : {&a, &b})  // needles
                for (Vec3& v : mesh->vertices) v = v.cwiseProduct(Vec3(1, 1e-3, 1e-5));
        for (Mesh* mesh : {&a, &b})
            for (Vec3& v : mesh->vertices) v *= scale;
        Pose pose = pose_of_query(random);
        pose.translation *= scale;
        const auto packed_a = build_packed<Codec>(a), packed_b = build_packed<Codec>(b);
        const PackedCollider<Codec> side_a{packed_a, a}, side_b{packed_b, b};
        const Placement placed = placement_of(side_a, side_b, pose);
        NearSearch search;
        search.limit = HUGE_VALF;
        search.take = [&](IndexPair pair, float least, float most) {
            const double exact =
                triangle_distance(corners(a, pair.a), transform_corners(pose, corners(b, pair.b)))
                    .distance;
            ++all;
            EXPECT_LE(static_cast<double>(least), exact);
            EXPECT_GE(static_cast<double>(most), exact);
            close += static_cast<double>(most - least) < 1e-4 * (exact + scale);
        };
        find_near(PackedQuery<Codec>{&packed_a, &packed_b, &placed},
                  {leaves_of(side_a), leaves_of(side_b), &placed}, SimdLevel::best, 0, search);
        EXPECT_EQ(search.n_bounded, a.triangles.size() * b.triangles.size());
        if (HasFailure()) return;
    }
    EXPECT_GT(close, all * 8 / 10) << "the bounds are far apart";
}

TEST(NearSearch, DistancesInLanesHaveTheBitsOfTheReference) {
    Random random(57);
    int apart = 0;
    for (int i = 0; i < scenes_tried; ++i) {
        SCOPED_TRACE(i);
        Mesh a = small_mesh(random, 9), b = small_mesh(random, 9);
        if (random.below(4) == 0)
            for (Vec3& v : a.vertices) v = v.cwiseProduct(Vec3(1, 1e-3, 1e-9));
        const Pose pose = pose_of_query(random);
        std::vector<IndexPair> pairs;
        std::vector<double> expected;
        for (std::uint32_t k = 0; k < a.triangles.size(); ++k)
            for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
                const double exact =
                    triangle_distance(corners(a, k), transform_corners(pose, corners(b, j)))
                        .distance;
                if (exact == 0) continue;
                pairs.push_back({k, j});
                expected.push_back(exact);
            }
        apart += static_cast<int>(pairs.size());
        std::vector<double> found(pairs.size());
        for (const SimdLevel level : available_simd_levels()) {
            distances_apart(a, b, pose, level, pairs, found.data());
            EXPECT_EQ(found, expected) << simd_level_name(level);
        }
        if (HasFailure()) return;
    }
    EXPECT_GT(apart, 10 * scenes_tried);
}

/// A fan of triangles about (0, 0, 0), all of it below z = 0: a pyramid without its base.
Mesh fan(Random& random, int sides) {
    Mesh mesh;
    mesh.vertices.push_back(Vec3::Zero());
    for (int k = 0; k < sides; ++k) {
        const double turn = 6.28 * k / sides;
        mesh.vertices.emplace_back(std::cos(turn), std::sin(turn), -random.uniform(0.1, 1));
    }
    for (int k = 0; k < sides; ++k)
        mesh.triangles.push_back({0, static_cast<std::uint32_t>(k + 1),
                                  static_cast<std::uint32_t>((k + 1) % sides + 1)});
    return mesh;
}

// Two tips that face each other are the closest points of all pairs of triangles.
TEST(DistancePacked, IsThatOfTheReferenceWhereFansFaceEachOther) {
    Random random(58);
    for (int i = 0; i < scenes_tried / 80; ++i) {
        SCOPED_TRACE(i);
        const Mesh a = fan(random, 3 + static_cast<int>(random.below(30))),
                   b = fan(random, 3 + static_cast<int>(random.below(30)));
        Mat3 over = Mat3::Identity();
        over(1, 1) = over(2, 2) = -1;
        const Mat3 turn = random_rotation(random);
        const Vec3 apart = std::pow(10, random.uniform(-9, 2)) *
                           Vec3(0.1 * random.uniform(-1, 1), 0.1 * random.uniform(-1, 1), 1);
        const Pose pose{over, apart};
        expect_reference_distance(BuiltMesh(a), BuiltMesh(b), pose);
        // In turned frames, where tips are not at the origin.
        Mesh turned = b;
        for (Vec3& v : turned.vertices) v = rotate(turn, v) + Vec3(0.3, 0.4, 0.5);
        const Mat3 back = pose.rotation * turn.transpose();
        expect_reference_distance(BuiltMesh(a), BuiltMesh(turned),
                                  {back, Vec3(apart - rotate(back, Vec3(0.3, 0.4, 0.5)))});
        if (HasFailure()) return;
    }
}

// Products of such lengths leave the range of floats.
TEST(DistancePacked, IsThatOfTheReferenceBeyondTheRangeOfFloats) {
    Mesh large = height_field(3);
    for (Vec3& v : large.vertices) v *= 1e8;
    const BuiltMesh body(large);
    for (const double far : {1e10, 1e15, 1e20, 1e30}) {
        SCOPED_TRACE(far);
        const Pose pose{Mat3::Identity(), far * Vec3(0.6, -0.4, 0.7)};
        for_each_packed(
            body, body,
            [&](const auto& packed_a, const auto& packed_b, const auto& of_a, const auto& of_b) {
                const Distance expected = distance(of_a, of_b, pose);
                expect_same_answer(distance_packed(packed_a, packed_b, pose), expected, body.mesh,
                                   body.mesh, pose);
                for (const double tolerance : {0.9, 1.0, 1.1})
                    EXPECT_EQ(
                        within_packed(packed_a, packed_b, pose, tolerance * expected.found.distance)
                            .pairs,
                        within(of_a, of_b, pose, tolerance * expected.found.distance).pairs);
            });
    }
}

TEST(SharedCorners, HaveTheDistanceOfTheReference) {
    Random random(59);
    int shared = 0;
    for (int i = 0; i < 20 * scenes_tried; ++i) {
        SCOPED_TRACE(i);
        const double size = std::pow(10, random.uniform(-8, 0)),
                     apart = std::pow(10, random.uniform(-8, 0));
        const auto triangle = [&](const Vec3& at) {
            const double thin = std::pow(10, random.uniform(-8, 0));
            const Vec3 along = size * random_point(random);
            return TriangleCorners{at, at + along, at + along + thin * size * random_point(random)};
        };
        const Vec3 u = random_point(random), w = u + apart * random_point(random);
        const TriangleDistance of_corners{std::sqrt(squared_norm(Vec3(u - w))), u, w};
        const TriangleCorners a = triangle(u), b = triangle(w);
        if (!is_distance_of_corners(a, b, of_corners)) continue;
        ++shared;
        EXPECT_EQ(triangle_distance(a, b).distance, of_corners.distance);
    }
    EXPECT_GT(shared, scenes_tried / 2);
}

TEST(DistancePacked, RefusesDifferentLayouts) {
    const BuiltMesh body(height_field(4));
    const Hierarchy<Scb2>& two_slabs = scb_of<Scb2>(body);
    const AnyPacked eight = pack_any({.width = 8}, two_slabs, body.mesh),
                    four = pack_any({.width = 4}, two_slabs, body.mesh);
    const Pose pose{Mat3::Identity(), Vec3(0, 0, 2)};
    const Distance expected = distance<Scb2>({two_slabs, body.mesh}, {two_slabs, body.mesh}, pose);
    const PackedDistance found = distance_packed(eight, body.mesh, eight, body.mesh, pose);
    expect_same_answer(found, expected, body.mesh, body.mesh, pose);
    EXPECT_EQ(
        within_packed(four, body.mesh, four, body.mesh, pose, found.found.distance).pairs,
        within<Scb2>({two_slabs, body.mesh}, {two_slabs, body.mesh}, pose, found.found.distance)
            .pairs);
    EXPECT_THROW(distance_packed(eight, body.mesh, four, body.mesh, pose), InputError);
    EXPECT_THROW(within_packed(eight, body.mesh, four, body.mesh, pose, 1), InputError);
}

}  // namespace
}  // namespace scb
