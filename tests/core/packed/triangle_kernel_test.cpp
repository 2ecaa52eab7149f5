#include "core/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/packed/triangle_kernel_test.cpp"
#include <hwy/foreach_target.h>
// After the line above.
#include "core/packed/leaf_pairs-inl.h"
#include "tests/core/packed/kernel_pairs.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

void ask_kernel(const std::vector<KernelPair>& pairs, std::vector<KernelAnswer>& answers) {
    constexpr int n = part_lanes(16);
    answers.resize(pairs.size());
    for (std::size_t first = 0; first < pairs.size(); first += n) {
        const int count = static_cast<int>(std::min(pairs.size() - first, std::size_t{n}));
        float rows[16][n] = {};
        for (int k = 0; k < count; ++k) {
            const KernelPair& pair = pairs[first + static_cast<std::size_t>(k)];
            for (int i = 0; i < 15; ++i) rows[i][k] = pair.seen[static_cast<std::size_t>(i)];
            rows[15][k] = pair.error;
        }
        const auto point = [&rows](int i) HWY_ATTR {
            return Lanes3<n>{Lanes<n>::load(rows[3 * i]), Lanes<n>::load(rows[3 * i + 1]),
                             Lanes<n>::load(rows[3 * i + 2])};
        };
        const TrianglePairs<n> lanes = {point(0), point(1), point(2),
                                        point(3), point(4), Lanes<n>::load(rows[15])};
        const Heights<n> q = heights_of_q(lanes), p = heights_of_p(lanes);
        const EdgeSides<n> sides = edge_sides(lanes);
        float determinants[15][n];
        for (int i = 0; i < 3; ++i) {
            q.h[i].store(determinants[i]);
            p.h[i].store(determinants[3 + i]);
            for (int j = 0; j < 3; ++j) sides.of[i][j].store(determinants[6 + 3 * i + j]);
        }
        const std::uint32_t meet = planes_meet(lanes).bits();
        const Certainty<n> certain = intersection(lanes);
        const std::uint32_t yes = certain.intersect.bits(), open = certain.open.bits();
        for (int k = 0; k < count; ++k) {
            KernelAnswer& answer = answers[first + static_cast<std::size_t>(k)];
            for (std::size_t i = 0; i < 15; ++i) answer.determinants[i] = determinants[i][k];
            answer.planes_meet = (meet >> k & 1) != 0;
            answer.intersect = (yes >> k & 1) != 0;
            answer.open = (open >> k & 1) != 0;
        }
    }
}

void ask_leaves(const LeafQuery& query, std::uint32_t i, std::uint32_t j,
                std::vector<LeafLane>& lanes) {
    OpenPairs open;
    PackedFindings found;
    LeafPairs leaves(query, open, found);
    lanes.clear();
    leaves.for_each_part(i, j,
                         [&]<int n>(const TrianglePairs<n>& pairs, std::uint32_t valid,
                                    const PackedLeaf& a, const PackedLeaf& b, int first) HWY_ATTR {
                             float rows[16][n];
                             const Lanes3<n>* const points[] = {&pairs.p1, &pairs.p2, &pairs.q0,
                                                                &pairs.q1, &pairs.q2};
                             for (int k = 0; k < 5; ++k) {
                                 points[k]->x.store(rows[3 * k]);
                                 points[k]->y.store(rows[3 * k + 1]);
                                 points[k]->z.store(rows[3 * k + 2]);
                             }
                             pairs.error.store(rows[15]);
                             for (int k = 0; k < n; ++k) {
                                 if ((valid >> k & 1) == 0) continue;
                                 const auto lane = static_cast<std::size_t>(first + k);
                                 LeafLane& at = lanes.emplace_back();
                                 at.pair = {a.triangle(lane % 4), b.triangle(lane / 4)};
                                 for (std::size_t r = 0; r < 15; ++r)
                                     at.kernel.seen[r] = rows[r][k];
                                 at.kernel.error = rows[15][k];
                             }
                         });
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "scb/hierarchy.h"
#include "scb/triangle_overlap.h"
#include "tests/core/geometry/triangle_pairs.h"
#include "tests/core/overlap/volume_pairs.h"
#include "tests/core/packed/touching_triangles.h"

namespace scb {
namespace {

HWY_EXPORT(ask_kernel);
HWY_EXPORT(ask_leaves);

double determinant(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return dot(cross(Vec3(b - a), Vec3(c - a)), Vec3(d - a));
}
/// Number k of KernelAnswer::determinants.
double determinant(const TrueCorners& c, std::size_t k) {
    if (k < 3) return determinant(corner_p(c, 0), corner_p(c, 1), corner_p(c, 2), corner_q(c, k));
    if (k < 6)
        return determinant(corner_q(c, 0), corner_q(c, 1), corner_q(c, 2), corner_p(c, k - 3));
    const std::size_t i = (k - 6) / 3, j = (k - 6) % 3;
    return determinant(corner_p(c, i), corner_p(c, i + 1), corner_q(c, j), corner_q(c, j + 1));
}

template <class Corners>
double largest_of(const Corners& c) {
    double largest = 0;
    for (const auto x : c) largest = std::max(largest, std::abs(static_cast<double>(x)));
    return largest;
}

/// What corners are moved for: a determinant, or one triangle as a whole above the other's plane.
constexpr std::uint32_t goals = 17;
double goal(const TrueCorners& c, std::size_t k) {
    if (k < 15) return determinant(c, k);
    const std::size_t first = 3 * (k - 15);
    return determinant(c, first) + determinant(c, first + 1) + determinant(c, first + 2);
}

/// Moves every number by `error`, up or down, so that goal k changes most, or nearly so, towards
/// `sign`: it is linear in each corner, so numbers are turned over one by one.
TrueCorners moved(Random& random, const TrueCorners& from, std::size_t k, double sign,
                  double error) {
    TrueCorners to = from;
    std::array<double, 15> step;
    for (std::size_t i = 0; i < 15; ++i) {
        step[i] = random.below(2) == 0 ? error : -error;
        to[i] += step[i];
    }
    for (int round = 0; round < 3; ++round)
        for (std::size_t i = 0; i < 15; ++i) {
            const double before = goal(to, k);
            to[i] = from[i] - step[i];
            if (sign * (goal(to, k) - before) < 0)
                to[i] = from[i] + step[i];
            else
                step[i] = -step[i];
        }
    return to;
}

/// As floats, with the error that they have.
KernelPair seen(const TrueCorners& moved, const TrueCorners& truth) {
    KernelPair pair;
    double error = 0;
    for (std::size_t i = 0; i < 15; ++i) {
        pair.seen[i] = static_cast<float>(moved[i]);
        error = std::max(error, std::abs(static_cast<double>(pair.seen[i]) - truth[i]));
    }
    pair.error = static_cast<float>(error);
    if (pair.error < error) pair.error = std::nextafter(pair.error, 1e30f);
    return pair;
}

/// The answers at all levels, which are the same.
std::vector<KernelAnswer> answers_of(const std::vector<KernelPair>& pairs) {
    std::vector<KernelAnswer> best, answers;
    SCB_AT_LEVEL(ask_kernel, SimdLevel::best)(pairs, best);
    for (const SimdLevel level : available_simd_levels()) {
        SCB_AT_LEVEL(ask_kernel, level)(pairs, answers);
        EXPECT_EQ(answers, best) << simd_level_name(level);
    }
    return best;
}

constexpr std::array<HWY_NAMESPACE::ErrorFactors, 3> bounds = {
    HWY_NAMESPACE::q_height_bound, HWY_NAMESPACE::p_height_bound, HWY_NAMESPACE::edge_bound};
std::size_t bound_of(std::size_t k) { return k < 3 ? 0 : k < 6 ? 1 : 2; }

/// D of the kernel.
double cube(const KernelPair& pair) {
    return largest_of(pair.seen) + static_cast<double>(pair.error);
}

/// The bound of determinant k.
double bound(const KernelPair& pair, std::size_t k) {
    const double d = cube(pair);
    const HWY_NAMESPACE::ErrorFactors factors = bounds[bound_of(k)];
    return d * d *
               (static_cast<double>(factors.data) * static_cast<double>(pair.error) +
                static_cast<double>(factors.rounding) * 0x1p-24 * d) +
           static_cast<double>(HWY_NAMESPACE::kernel_underflow<float>);
}

// No determinant is farther off than its bound says. In units of D^2 e, the worst that are found
// here are off by 12, 48 and 48, where the bounds have 19, 49 and 49.
TEST(TriangleKernel, DeterminantsAreWithinTheirBounds) {
    Random random(1);
    std::vector<KernelPair> pairs;
    std::vector<TrueCorners> truths;
    for (int i = 0; i < 400'000 / effort; ++i) {
        // Corners of a cube, or anywhere in it.
        const double size = std::ldexp(1.0, static_cast<int>(random.below(71)) - 50);
        TrueCorners truth;
        for (double& x : truth) {
            x = random.below(4) != 0 ? 1 : random.uniform();
            x *= random.below(2) == 0 ? size : -size;
        }
        const double error = size * std::ldexp(1.0, 1 - static_cast<int>(random.below(20)));
        const double sign = random.below(2) == 0 ? 1 : -1;
        pairs.push_back(seen(moved(random, truth, random.below(15), sign, error), truth));
        truths.push_back(truth);
    }
    const std::vector<KernelAnswer> answers = answers_of(pairs);
    std::array<double, 3> worst = {};
    int beyond = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (std::size_t k = 0; k < 15; ++k) {
            const double off = std::abs(static_cast<double>(answers[i].determinants[k]) -
                                        determinant(truths[i], k)),
                         size = cube(pairs[i]),
                         unit = size * size * static_cast<double>(pairs[i].error);
            if (off > bound(pairs[i], k)) ++beyond;
            if (size > 0x1p-20 && unit > 0x1p-16 * size * size * size)
                worst[bound_of(k)] = std::max(worst[bound_of(k)], off / unit);
        }
    EXPECT_EQ(beyond, 0);
    constexpr std::array<double, 3> reached = {11.9, 47.5, 47.5};
    for (std::size_t b = 0; b < 3; ++b) EXPECT_GT(worst[b], reached[b]);
}

// The same of corners that floats hold exactly, so that all errors are of rounding. Corners with
// the largest error of a round are changed a little for the next. Roundings rarely add up: in
// units of u D^3, the worst that are found here are off by 10, 66 and 51, where the bounds have 31,
// 205 and 229.
TEST(TriangleKernel, RoundingIsWithinItsBounds) {
    Random random(6);
    constexpr std::size_t kept = 64;
    const auto number = [&random] {
        const double x = random.below(2) == 0 ? 1 - 0x1p-10 * random.uniform() : random.uniform();
        return static_cast<float>(random.below(2) == 0 ? x : -x);
    };
    std::array<double, 3> worst = {};
    for (std::size_t b = 0; b < 3; ++b) {
        std::vector<KernelPair> best(kept);
        for (KernelPair& pair : best)
            for (float& x : pair.seen) x = number();
        for (int round = 0; round < 200 / effort; ++round) {
            std::vector<KernelPair> pairs = best;
            for (std::size_t i = kept; i < 32 * kept; ++i) {
                KernelPair& changed = pairs.emplace_back(best[i % kept]);
                for (std::uint32_t times = 1 + random.below(3); times > 0; --times) {
                    float& x = changed.seen[random.below(15)];
                    x = random.below(2) == 0 ? number()
                                             : static_cast<float>(static_cast<double>(x) *
                                                                  (1 - 0x1p-20 * random.uniform()));
                }
            }
            const std::vector<KernelAnswer> answers = answers_of(pairs);
            std::vector<std::pair<double, std::size_t>> order;
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                TrueCorners truth;
                std::copy(pairs[i].seen.begin(), pairs[i].seen.end(), truth.begin());
                double most = 0;
                for (std::size_t k = 0; k < 15; ++k) {
                    const double off = std::abs(static_cast<double>(answers[i].determinants[k]) -
                                                determinant(truth, k));
                    EXPECT_LE(off, bound(pairs[i], k));
                    if (bound_of(k) == b)
                        most = std::max(most, off / (0x1p-24 * std::pow(cube(pairs[i]), 3)));
                }
                order.push_back({-most, i});
            }
            std::sort(order.begin(), order.end());
            for (std::size_t i = 0; i < kept; ++i) best[i] = pairs[order[i].second];
            worst[b] = std::max(worst[b], -order[0].first);
        }
    }
    constexpr std::array<double, 3> reached = {9, 55, 45};
    for (std::size_t b = 0; b < 3; ++b) EXPECT_GT(worst[b], reached[b]);
}

double normal_length(const TrueCorners& c, bool of_p) {
    const auto at = [&](std::size_t i) { return of_p ? corner_p(c, i) : corner_q(c, i); };
    return std::sqrt(squared_norm(cross(Vec3(at(1) - at(0)), Vec3(at(2) - at(0)))));
}

// The same of the lengths of normals.
TEST(TriangleKernel, LengthsOfNormalsAreWithinTheirBound) {
    Random random(4);
    double worst = 0;
    for (int i = 0; i < 100'000 / effort; ++i) {
        TrueCorners truth, off = {};
        for (double& x : truth) x = random.below(2) == 0 ? 1 : -1;
        const double error = std::ldexp(1.0, -10 - static_cast<int>(random.below(8)));
        for (std::size_t k = 0; k < 15; ++k)
            off[k] = truth[k] + (random.below(2) == 0 ? error : -error);
        for (const bool of_p : {true, false})
            worst =
                std::max(worst, (normal_length(truth, of_p) - normal_length(off, of_p)) / error);
    }
    EXPECT_LE(worst, static_cast<double>(HWY_NAMESPACE::normal_bound.data));
    EXPECT_GT(worst, 12);
}

bool overlap(const TrueCorners& c) {
    return triangles_overlap({corner_p(c, 0), corner_p(c, 1), corner_p(c, 2)},
                             {corner_q(c, 0), corner_q(c, 1), corner_q(c, 2)});
}

// What the kernel is certain of is so, where rounding has done its worst to triangles that touch.
TEST(TriangleKernel, IsNeverCertainOfWhatIsNotSo) {
    Random random(2);
    std::vector<KernelPair> pairs;
    std::vector<bool> overlaps;
    while (pairs.size() < static_cast<std::size_t>(600'000 / effort)) {
        const TrueCorners truth = touching(random);
        const double size = largest_of(truth);
        if (size == 0) continue;
        const double error = size * std::ldexp(1.0, -3 - static_cast<int>(random.below(15)));
        const double sign = random.below(2) == 0 ? 1 : -1;
        pairs.push_back(seen(moved(random, truth, random.below(goals), sign, error), truth));
        overlaps.push_back(overlap(truth));
    }
    const std::vector<KernelAnswer> answers = answers_of(pairs);
    std::array<int, 3> wrong = {}, certain = {};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const KernelAnswer& answer = answers[i];
        const bool beside = !answer.intersect && !answer.open;
        certain[0] += !answer.planes_meet;
        certain[1] += answer.intersect;
        certain[2] += beside;
        wrong[0] += !answer.planes_meet && overlaps[i];
        wrong[1] += answer.intersect && !overlaps[i];
        wrong[2] += beside && overlaps[i];
    }
    const std::array<int, 3> none = {};
    EXPECT_EQ(wrong, none);
    EXPECT_GT(certain[0], 1000 / effort);
    EXPECT_GT(certain[1], 1000 / effort);
    EXPECT_GT(certain[2], 50 / effort);
}

template <class Codec>
std::vector<PackedRef> leaves_of(const PackedHierarchy<Codec>& packed) {
    if (packed.root.is_leaf()) return {packed.root};
    std::vector<PackedRef> leaves;
    for (const PackedNode<Codec>& node : packed.nodes)
        for (std::uint32_t k = 0; k < node.count; ++k)
            if (PackedRef{node.child[k]}.is_leaf()) leaves.push_back({node.child[k]});
    return leaves;
}

/// Triangles of all sizes up to the size of their cloud.
Mesh random_triangles(Random& random, const Vec3& center, double cloud) {
    Mesh mesh;
    const double size = std::ldexp(1.0, -static_cast<int>(random.below(12)));
    for (std::uint32_t t = 0; t < 6; ++t) {
        const Vec3 at = random_point(random);
        for (int k = 0; k < 3; ++k)
            mesh.vertices.push_back(center + cloud * (at + size * random_point(random)));
        mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return mesh;
}

// Corners that leaves give to the kernel are as near to the meshes' corners as the leaves state.
// Some are off by 0.3 of the stated error.
TEST(TriangleKernel, CornersOfLeavesAreWithinTheirError) {
    Random random(3);
    double worst = 0;
    std::vector<LeafLane> lanes;
    for (int i = 0; i < 3000 / effort; ++i) {
        // So far away and so small that doubles are all that is off.
        const double far = std::array{0.0, 100.0, 1e6, 4e7}[static_cast<std::size_t>(i % 4)],
                     cloud = i % 4 == 3 ? 1e-6 : 1;
        const Vec3 center(far, -far, far);
        const Mesh a = random_triangles(random, center, cloud),
                   b = random_triangles(random, -center, cloud);
        Pose pose = random_pose(random);
        pose.translation = cloud * pose.translation + a.vertices[0] - pose.rotation * b.vertices[0];
        const auto packed_a = pack<FloatCodec<4>>(build_hierarchy<Scb>(a), a),
                   packed_b = pack<FloatCodec<4>>(build_hierarchy<Scb>(b), b);
        const Placement placed = placement(pose, 4 * packed_a.reach, 4 * packed_b.reach);
        const LeafQuery query{
            {packed_a.leaves.data(), nullptr}, {packed_b.leaves.data(), nullptr}, &placed};
        for (const SimdLevel level : available_simd_levels())
            for (const PackedRef of_a : leaves_of(packed_a))
                for (const PackedRef of_b : leaves_of(packed_b)) {
                    SCB_AT_LEVEL(ask_leaves, level)(query, of_a.bits, of_b.bits, lanes);
                    for (const LeafLane& lane : lanes) {
                        const TriangleCorners p = corners(a, lane.pair.a),
                                              q = transform_corners(pose, corners(b, lane.pair.b));
                        const Vec3 points[] = {p[1], p[2], q[0], q[1], q[2]};
                        for (std::size_t r = 0; r < 15; ++r) {
                            const int axis = static_cast<int>(r % 3);
                            const double off = std::abs(static_cast<double>(lane.kernel.seen[r]) -
                                                        (points[r / 3][axis] - p[0][axis]));
                            worst = std::max(worst, off / static_cast<double>(lane.kernel.error));
                        }
                    }
                }
    }
    EXPECT_LE(worst, 1);
    EXPECT_GT(worst, 1.0 / 4);
}

}  // namespace
}  // namespace scb
#endif
