#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/distance/distance_certificate.h"
#include "core/geometry/exact_sum.h"

// The checker of certificates. It uses neither the search nor volumes. A distance of 0 rests on the
// exact test of two triangles.
//
// With u = 2^-53, each rounding of a normal number changes it by a factor of 1 - u to 1 + u.
// Factors such as 1 - 32 u are for more roundings than there are. Numbers below the normal ones are
// wrong by 2^-1075 at most, a few times: `underflow` is more.

namespace scb {
namespace {

constexpr double unit = 0x1p-53;
/// More than all that underflow takes away.
constexpr double underflow = 0x1p-1000;

using Product = std::array<double, 2>;

/// The sum, to a relative error of 2^-50 or an absolute error of 2^-1074; 0 only if it is 0.
template <std::size_t N>
double sum_of_products(const std::array<Product, N>& products) {
    const Dyadic one(1);
    int lowest = std::numeric_limits<int>::max(), highest = std::numeric_limits<int>::min();
    for (const auto& [x, y] : products) {
        if (x == 0 || y == 0) continue;
        const int exponent = Dyadic(x).exponent + Dyadic(y).exponent + one.exponent;
        lowest = std::min(lowest, exponent);
        highest = std::max(highest, exponent);
    }
    if (lowest > highest) return 0;
    ExactSum sum(lowest, highest);
    for (const auto& [x, y] : products) sum.add(Dyadic(x), Dyadic(y), one);
    const ScaledDouble value = sum.value();
    const double rounded = std::ldexp(value.significand, value.exponent);
    if (rounded != 0 || value.significand == 0) return rounded;
    return std::copysign(std::numeric_limits<double>::denorm_min(), value.significand);
}

/// n.(q - p), rounded likewise.
double exact_gap(const Vec3& n, const Vec3& p, const Vec3& q) {
    return sum_of_products<6>(
        {{{n[0], q[0]}, {n[1], q[1]}, {n[2], q[2]}, {-n[0], p[0]}, {-n[1], p[1]}, {-n[2], p[2]}}});
}

/// The point whose n.p is the largest. `computed`: the largest that was computed, with an error of
/// at most `error`, as all others have.
Vec3 farthest(std::span<const Vec3> points, const Vec3& n, double computed, double error) {
    const Vec3* best = nullptr;
    for (const Vec3& p : points)
        if (dot(n, p) >= computed - 4 * error && (!best || exact_gap(n, *best, p) > 0)) best = &p;
    return *best;
}

/// A bound above the distance of two points; no value if a point is not one of a triangle.
std::optional<double> distance_of_points(const SurfacePoint& on_a, const SurfacePoint& on_b,
                                         const MeshTree& a, const MeshTree& b, const Pose& b_to_a) {
    const auto is_share = [](double share) { return share >= 0 && share <= 0.5; };
    const auto is_valid = [&](const SurfacePoint& p, const Mesh& mesh) {
        return p.triangle < mesh.triangles.size() && p.corner < 3 && is_share(p.to_next) &&
               is_share(p.to_after);
    };
    if (!is_valid(on_a, a.mesh) || !is_valid(on_b, b.mesh)) return {};
    const TriangleCorners of_a = corners(a.mesh, on_a.triangle),
                          of_b = transform_corners(b_to_a, corners(b.mesh, on_b.triangle));
    Vec3 apart;
    for (int axis = 0; axis < 3; ++axis) {
        std::array<Product, 10> products;
        const auto put = [&](std::size_t from, const SurfacePoint& at, const TriangleCorners& t,
                             double sign) {
            const double corner = t[at.corner][axis];
            products[from] = {sign, corner};
            products[from + 1] = {-sign * at.to_next, corner};
            products[from + 2] = {sign * at.to_next, t[(at.corner + 1) % 3][axis]};
            products[from + 3] = {-sign * at.to_after, corner};
            products[from + 4] = {sign * at.to_after, t[(at.corner + 2) % 3][axis]};
        };
        put(0, on_a, of_a, 1);
        put(5, on_b, of_b, -1);
        apart[axis] = sum_of_products(products);
    }
    const double most = apart.cwiseAbs().maxCoeff();
    if (most == 0) return 0;
    // Scaled, squares do not underflow where it matters.
    return most * std::sqrt(squared_norm(Vec3(apart / most))) * (1 + 64 * unit) + underflow;
}

/// Adds the children of a node, for which the pair has a place; false if they do not make it up.
bool push_children(std::vector<std::array<std::uint32_t, 2>>& pending,
                   std::array<std::uint32_t, 2> pair, std::size_t side, const Topology& topology) {
    const TopologyNode& node = topology.nodes[pair[side]];
    if (node.is_leaf() || std::size_t{node.left} + 1 >= topology.nodes.size()) return false;
    const TopologyNode &left = topology.nodes[node.left], &right = topology.nodes[node.left + 1];
    if (left.first != node.first || right.first != std::uint64_t{left.first} + left.count ||
        std::uint64_t{left.count} + right.count != node.count)
        return false;
    for (const std::uint32_t child : {node.left + 1, node.left}) {
        pair[side] = child;
        pending.push_back(pair);
    }
    return true;
}

}  // namespace

double proven_gap(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& direction,
                  double magnitude, double enough) {
    const double most = direction.cwiseAbs().maxCoeff();
    if (!direction.allFinite() || !(most > 0)) return 0;
    // Any multiple of the direction will do. After this one, no component is above 1.
    int exponent = 0;
    std::frexp(most, &exponent);
    Vec3 n;
    for (int axis = 0; axis < 3; ++axis) n[axis] = std::ldexp(direction[axis], -exponent);
    double highest_of_a = -HUGE_VAL, lowest_of_b = HUGE_VAL;
    for (const Vec3& p : a) highest_of_a = std::max(highest_of_a, dot(n, p));
    for (const Vec3& q : b) lowest_of_b = std::min(lowest_of_b, dot(n, q));
    // Each of the three terms of a scalar product meets at most three roundings, so the product is
    // wrong by at most 3 u (1 + 2 u) of the sum of their magnitudes. The rest of 4 u is for the
    // roundings of `magnitude` and of the difference below.
    const double error = 4 * unit * magnitude + underflow,
                 length = std::sqrt(squared_norm(n)),  // to 3 u, and at least 1/2
        rough = (lowest_of_b - highest_of_a - error) / length * (1 - 32 * unit);
    if (rough >= enough || rough + 8 * error < enough) return std::max(rough, 0.0);
    const double gap =
        exact_gap(n, farthest(a, n, highest_of_a, error), farthest(b, -n, -lowest_of_b, error)) /
        length * (1 - 64 * unit);
    return gap > underflow ? gap : 0;
}

ProvenDistance check_distance(const MeshTree& a, const MeshTree& b, const Pose& b_to_a,
                              const DistanceCertificate& certificate) {
    const auto fail = [](std::string fault) { return ProvenDistance{std::move(fault)}; };
    const PlacedCorners of_a = placed_corners(a, nullptr), of_b = placed_corners(b, &b_to_a);
    if (!of_a.fault.empty()) return fail("A: " + of_a.fault);
    if (!of_b.fault.empty()) return fail("B: " + of_b.fault);
    ProvenDistance proven;
    proven.largest_coordinate = std::max(of_a.largest_coordinate, of_b.largest_coordinate);
    const auto& [on_a, on_b, cut, directions] = certificate;
    const auto upper = distance_of_points(on_a, on_b, a, b, b_to_a);
    if (!upper) return fail("a point is not one of a triangle.");
    proven.upper = *upper;
    const double magnitude = 3 * (of_a.largest_coordinate + of_b.largest_coordinate);
    double lower = HUGE_VAL;
    std::size_t ends = 0;
    std::vector<std::array<std::uint32_t, 2>> pending = {{0, 0}};
    for (const CutStep step : cut) {
        if (pending.empty()) return fail("the cut goes on after all pairs have ended.");
        const std::array<std::uint32_t, 2> pair = pending.back();
        pending.pop_back();
        if (step == CutStep::divide_a || step == CutStep::divide_b) {
            const bool is_a = step == CutStep::divide_a;
            if (!push_children(pending, pair, is_a ? 0 : 1, is_a ? a.topology : b.topology))
                return fail("the cut divides a node whose children do not make it up.");
        } else if (step == CutStep::end && ends < directions.size()) {
            const double gap = proven_gap(of_a.below(a.topology.nodes[pair[0]]),
                                          of_b.below(b.topology.nodes[pair[1]]), directions[ends],
                                          magnitude, std::min(lower, *upper));
            lower = std::min(lower, gap);
            ++ends;
        } else {
            return fail("the cut has an unknown step, or too few directions.");
        }
    }
    if (ends != directions.size()) return fail("the cut has too many directions.");
    if (!cut.empty() && !pending.empty()) return fail("the cut leaves out pairs of triangles.");
    if (!cut.empty()) proven.lower = std::min(lower, *upper);
    if (cut.empty() && triangles_overlap(corners(a.mesh, on_a.triangle),
                                         transform_corners(b_to_a, corners(b.mesh, on_b.triangle))))
        proven.upper = 0;
    return proven;
}

}  // namespace scb
