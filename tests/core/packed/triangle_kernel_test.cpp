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
        float rows[18][n] = {};
        for (int k = 0; k < count; ++k) {
            const KernelPair& pair = pairs[first + static_cast<std::size_t>(k)];
            for (int i = 0; i < 15; ++i) rows[i][k] = pair.seen[static_cast<std::size_t>(i)];
            for (int i = 0; i < 3; ++i) rows[15 + i][k] = pair.errors[static_cast<std::size_t>(i)];
        }
        const auto lane = [&rows](int i) HWY_ATTR { return Lanes<n>::load(rows[i]); };
        const auto point = [&lane](int i) HWY_ATTR {
            return Lanes3<n>{lane(3 * i), lane(3 * i + 1), lane(3 * i + 2)};
        };
        const TrianglePairs<n> lanes = {point(0), point(1), point(2), point(3),
                                        point(4), lane(15), lane(16), lane(17)};
        const Heights<n> heights(lanes);
        const EdgeSides<n> sides = edge_sides(lanes, heights);
        float determinants[15][n];
        for (int i = 0; i < 3; ++i) {
            heights.of_q[i].store(determinants[i]);
            heights.of_p[i].store(determinants[3 + i]);
            for (int j = 0; j < 3; ++j) sides.of[i][j].store(determinants[6 + 3 * i + j]);
        }
        const Magnitudes<n> magnitudes(lanes);
        const HeightErrors<n> errors(lanes, magnitudes);
        float bounds[3][n];
        errors.of_q.store(bounds[0]);
        errors.of_p.store(bounds[1]);
        error_of_sides(lanes, magnitudes).store(bounds[2]);
        const std::uint32_t meet = planes_meet(lanes).bits();
        const Certainty<n> certain = intersection(lanes);
        const std::uint32_t yes = certain.intersect.bits(), open = certain.open.bits();
        for (int k = 0; k < count; ++k) {
            KernelAnswer& answer = answers[first + static_cast<std::size_t>(k)];
            for (std::size_t i = 0; i < 15; ++i) answer.determinants[i] = determinants[i][k];
            for (std::size_t i = 0; i < 3; ++i) answer.bounds[i] = bounds[i][k];
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
                             float rows[18][n];
                             const Lanes3<n>* const points[] = {&pairs.p1, &pairs.p2, &pairs.f1,
                                                                &pairs.f2, &pairs.w};
                             for (int k = 0; k < 5; ++k) {
                                 points[k]->x.store(rows[3 * k]);
                                 points[k]->y.store(rows[3 * k + 1]);
                                 points[k]->z.store(rows[3 * k + 2]);
                             }
                             pairs.error_p.store(rows[15]);
                             pairs.error_f.store(rows[16]);
                             pairs.error_w.store(rows[17]);
                             for (int k = 0; k < n; ++k) {
                                 if ((valid >> k & 1) == 0) continue;
                                 const auto lane = static_cast<std::size_t>(first + k);
                                 LeafLane& at = lanes.emplace_back();
                                 at.pair = {a.triangle(lane % 4), b.triangle(lane / 4)};
                                 for (std::size_t r = 0; r < 15; ++r)
                                     at.kernel.seen[r] = rows[r][k];
                                 for (std::size_t r = 0; r < 3; ++r)
                                     at.kernel.errors[r] = rows[15 + r][k];
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

PairParts<double> parts_of(const TrueCorners& c) {
    PairParts<double> parts;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        parts[axis] = c[axis];
        parts[3 + axis] = c[3 + axis];
        parts[6 + axis] = c[9 + axis] - c[6 + axis];
        parts[9 + axis] = c[12 + axis] - c[6 + axis];
        parts[12 + axis] = c[6 + axis];
    }
    return parts;
}
TrueCorners corners_of(const PairParts<double>& parts) {
    TrueCorners c;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        c[axis] = parts[axis];
        c[3 + axis] = parts[3 + axis];
        c[6 + axis] = parts[12 + axis];
        c[9 + axis] = parts[12 + axis] + parts[6 + axis];
        c[12 + axis] = parts[12 + axis] + parts[9 + axis];
    }
    return c;
}

/// What corners are moved for: a determinant, or one triangle as a whole above the other's plane.
constexpr std::uint32_t goals = 17;
double goal(const PairParts<double>& parts, std::size_t k) {
    const TrueCorners c = corners_of(parts);
    if (k < 15) return determinant(c, k);
    const std::size_t first = 3 * (k - 15);
    return determinant(c, first) + determinant(c, first + 1) + determinant(c, first + 2);
}

/// Moves every number by its error, up or down, so that goal k changes most, or nearly so, towards
/// `sign`: it is linear in each part, so numbers are turned over one by one.
PairParts<double> moved(Random& random, const PairParts<double>& from, std::size_t k, double sign,
                        const std::array<double, 3>& errors) {
    PairParts<double> to = from;
    std::array<double, 15> step;
    for (std::size_t i = 0; i < 15; ++i) {
        step[i] = errors[error_of_part(i)] * (random.below(2) == 0 ? 1 : -1);
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

/// As floats, with the errors that they have.
KernelPair seen(const PairParts<double>& moved, const PairParts<double>& truth) {
    KernelPair pair;
    std::array<double, 3> errors = {};
    for (std::size_t i = 0; i < 15; ++i) {
        pair.seen[i] = static_cast<float>(moved[i]);
        double& error = errors[error_of_part(i)];
        error = std::max(error, std::abs(static_cast<double>(pair.seen[i]) - truth[i]));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        pair.errors[i] = static_cast<float>(errors[i]);
        if (static_cast<double>(pair.errors[i]) < errors[i])
            pair.errors[i] = std::nextafter(pair.errors[i], 1e30f);
    }
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

std::size_t bound_of(std::size_t k) { return k < 3 ? 0 : k < 6 ? 1 : 2; }

/// How far the determinants of a pair are off, over their bounds: of heights above P, above Q, and
/// of sides.
std::array<double, 3> shares_of_bounds(const KernelAnswer& answer, const PairParts<double>& truth) {
    std::array<double, 3> shares = {};
    const TrueCorners corners = corners_of(truth);
    for (std::size_t k = 0; k < 15; ++k) {
        const double off =
            std::abs(static_cast<double>(answer.determinants[k]) - determinant(corners, k));
        double& share = shares[bound_of(k)];
        share = std::max(share, off / static_cast<double>(answer.bounds[bound_of(k)]));
    }
    return shares;
}

// No determinant is farther off than its bound says, for triangles of any two sizes. The worst that
// are found here are off by 0.65 of it.
TEST(TriangleKernel, DeterminantsAreWithinTheirBounds) {
    Random random(1);
    std::vector<KernelPair> pairs;
    std::vector<PairParts<double>> truths;
    for (int i = 0; i < 400'000 / effort; ++i) {
        const double size = std::ldexp(1.0, static_cast<int>(random.below(51)) - 30);
        std::array<double, 3> sizes, errors;
        for (std::size_t k = 0; k < 3; ++k) {
            sizes[k] = std::ldexp(size, -static_cast<int>(random.below(2) * random.below(12)));
            errors[k] = random.below(8) == 0
                            ? 0
                            : std::ldexp(sizes[k], 1 - static_cast<int>(random.below(20)));
        }
        // Corners of a cube, or anywhere in it.
        PairParts<double> truth;
        for (std::size_t k = 0; k < 15; ++k) {
            truth[k] = random.below(4) != 0 ? 1 : random.uniform();
            truth[k] *= sizes[error_of_part(k)] * (random.below(2) == 0 ? 1 : -1);
        }
        const double sign = random.below(2) == 0 ? 1 : -1;
        pairs.push_back(seen(moved(random, truth, random.below(15), sign, errors), truth));
        truths.push_back(truth);
    }
    const std::vector<KernelAnswer> answers = answers_of(pairs);
    std::array<double, 3> worst = {};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const std::array<double, 3> shares = shares_of_bounds(answers[i], truths[i]);
        for (std::size_t b = 0; b < 3; ++b) worst[b] = std::max(worst[b], shares[b]);
    }
    constexpr auto reached =
        unless_sanitized(std::array{0.64, 0.64, 0.64}, std::array{0.55, 0.55, 0.55});
    for (std::size_t b = 0; b < 3; ++b) {
        EXPECT_LE(worst[b], 1);
        EXPECT_GT(worst[b], reached[b]);
    }
}

// The same of numbers that floats hold exactly, so that all errors are of rounding. Pairs with the
// largest error of a round are changed a little for the next. Roundings rarely add up: the worst
// that are found here are off by 0.33, 0.34 and 0.12 of the bound.
TEST(TriangleKernel, RoundingIsWithinItsBounds) {
    Random random(6);
    constexpr std::size_t kept = 64;
    const auto number = [&random] {
        const double x = random.below(2) == 0 ? 1 - 0x1p-10 * random.uniform() : random.uniform();
        return static_cast<float>(random.below(2) == 0 ? x : -x);
    };
    std::array<double, 3> worst = {};
    for (std::size_t b = 0; b < 3; ++b) {
        std::vector<KernelPair> best(kept, KernelPair{});
        for (KernelPair& pair : best)
            for (float& x : pair.seen) x = number();
        for (int round = 0; round < unless_sanitized(60, 20); ++round) {
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
                PairParts<double> truth;
                std::copy(pairs[i].seen.begin(), pairs[i].seen.end(), truth.begin());
                order.push_back({-shares_of_bounds(answers[i], truth)[b], i});
            }
            std::sort(order.begin(), order.end());
            for (std::size_t i = 0; i < kept; ++i) best[i] = pairs[order[i].second];
            worst[b] = std::max(worst[b], -order[0].first);
        }
    }
    constexpr auto reached =
        unless_sanitized(std::array{0.3, 0.3, 0.11}, std::array{0.2, 0.2, 0.08});
    for (std::size_t b = 0; b < 3; ++b) {
        EXPECT_LE(worst[b], 1);
        EXPECT_GT(worst[b], reached[b]);
    }
}

// The same of triangles so small that products lose digits to the least exponent, or all.
TEST(TriangleKernel, UnderflowsAreWithinItsBounds) {
    Random random(9);
    std::vector<KernelPair> pairs;
    std::vector<PairParts<double>> truths;
    for (int i = 0; i < 20'000 / effort; ++i) {
        const double size = std::ldexp(1.0, -40 - static_cast<int>(random.below(40)));
        KernelPair& pair = pairs.emplace_back(KernelPair{});
        PairParts<double>& truth = truths.emplace_back();
        for (std::size_t k = 0; k < 15; ++k) {
            pair.seen[k] = static_cast<float>(size * (2 * random.uniform() - 1));
            truth[k] = static_cast<double>(pair.seen[k]);
        }
    }
    const std::vector<KernelAnswer> answers = answers_of(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (const double share : shares_of_bounds(answers[i], truths[i])) EXPECT_LE(share, 1) << i;
}

double normal_length(const PairParts<double>& parts, std::size_t first) {
    const auto edge = [&](std::size_t i) { return Vec3(parts[i], parts[i + 1], parts[i + 2]); };
    return std::sqrt(squared_norm(cross(edge(first), edge(first + 3))));
}

// The same of the lengths of normals.
TEST(TriangleKernel, LengthsOfNormalsAreWithinTheirBound) {
    Random random(4);
    double worst = 0;
    for (int i = 0; i < 100'000 / effort; ++i) {
        PairParts<double> truth, off = {};
        for (double& x : truth) x = random.below(2) == 0 ? 1 : -1;
        const double error = std::ldexp(1.0, -10 - static_cast<int>(random.below(8)));
        for (std::size_t k = 0; k < 15; ++k)
            off[k] = truth[k] + (random.below(2) == 0 ? error : -error);
        for (const std::size_t first : {0u, 6u})
            worst =
                std::max(worst, (normal_length(truth, first) - normal_length(off, first)) / error);
    }
    EXPECT_LE(worst, static_cast<double>(HWY_NAMESPACE::normal_bound));
    EXPECT_GT(worst, 5.5);
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
        double size = 0;
        for (const double x : truth) size = std::max(size, std::abs(x));
        if (size == 0) continue;
        std::array<double, 3> errors;
        for (double& error : errors)
            error = size * std::ldexp(1.0, -6 - static_cast<int>(random.below(18)));
        const double sign = random.below(2) == 0 ? 1 : -1;
        const PairParts<double> parts = parts_of(truth);
        pairs.push_back(seen(moved(random, parts, random.below(goals), sign, errors), parts));
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
// Some are off by 0.68, 0.46 and 0.29 of the stated errors.
TEST(TriangleKernel, CornersOfLeavesAreWithinTheirError) {
    Random random(3);
    std::array<double, 3> worst = {};
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
                        const Vec3 parts[] = {p[1] - p[0], p[2] - p[0], q[1] - q[0], q[2] - q[0],
                                              q[0] - p[0]};
                        for (std::size_t r = 0; r < 15; ++r) {
                            const double off = std::abs(static_cast<double>(lane.kernel.seen[r]) -
                                                        parts[r / 3][static_cast<int>(r % 3)]);
                            double& share = worst[error_of_part(r)];
                            share = std::max(
                                share,
                                off / static_cast<double>(lane.kernel.errors[error_of_part(r)]));
                        }
                    }
                }
    }
    constexpr auto reached =
        unless_sanitized(std::array{0.6, 0.4, 0.25}, std::array{0.5, 0.22, 0.2});
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_LE(worst[k], 1);
        EXPECT_GT(worst[k], reached[k]);
    }
}

}  // namespace
}  // namespace scb
#endif
