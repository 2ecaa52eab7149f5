#include "core/geometry/orientation.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <climits>
#include <cstddef>
#include <span>

namespace scb {
namespace {

static_assert(FLT_EVAL_METHOD == 0, "doubles must be rounded to doubles");

// The exponents of some values; zeros have none.
struct ExponentRange {
    int lowest = INT_MAX;
    int highest = INT_MIN;

    template <std::size_t N>
    explicit ExponentRange(const std::array<Dyadic, N>& values) {
        for (const Dyadic& v : values)
            if (v.mantissa != 0) {
                lowest = std::min(lowest, v.exponent);
                highest = std::max(highest, v.exponent);
            }
    }
    bool empty() const { return lowest > highest; }
};

// An empty sum for products of one value of each of three axes.
template <std::size_t N>
ExactSum sum_for(const std::array<Dyadic, N>& x, const std::array<Dyadic, N>& y,
                 const std::array<Dyadic, N>& z) {
    const ExponentRange rx(x), ry(y), rz(z);
    if (rx.empty() || ry.empty() || rz.empty()) return {0, 0};
    return {rx.lowest + ry.lowest + rz.lowest, rx.highest + ry.highest + rz.highest};
}

// p - q where that is a double: the error of the difference, by Knuth's two-sum, is zero.
// (Underflow never makes sums inexact; if they overflow, the error is not a number.)
bool exact_difference(double p, double q, double& difference) {
    difference = p - q;
    const double minus_q = difference - p, p_again = difference - minus_q;
    return (p - p_again) - (q + minus_q) == 0;
}

// One coordinate of the points, or its differences from the first point's if all of these are
// exact, which is usual: meshes have coordinates of few digits or of nearly the same magnitude. A
// shift along an axis does not change the determinant, and zeros save products.
template <std::size_t N>
struct Column {
    std::array<Dyadic, N> values;
    bool from_first = true;

    explicit Column(const std::array<double, N>& coordinates) {
        std::array<double, N> differences;
        for (std::size_t i = 0; i < N; ++i)
            from_first =
                from_first && exact_difference(coordinates[i], coordinates[0], differences[i]);
        for (std::size_t i = 0; i < N; ++i)
            values[i] = Dyadic(from_first ? differences[i] : coordinates[i]);
    }
};

// Adds the determinant of the rows i, j, k.
void add_determinant(ExactSum& sum, std::span<const Dyadic> x, std::span<const Dyadic> y,
                     std::span<const Dyadic> z, std::size_t i, std::size_t j, std::size_t k) {
    sum.add(x[i], y[j], z[k]);
    sum.add(x[j], y[k], z[i]);
    sum.add(x[k], y[i], z[j]);
    sum.subtract(x[i], y[k], z[j]);
    sum.subtract(x[j], y[i], z[k]);
    sum.subtract(x[k], y[j], z[i]);
}

// read(det(b - a, c - a, d - a)): a callback, since the sum is too large to return.
template <class Read>
auto determinant3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, Read read) {
    const Column<4> x({a[0], b[0], c[0], d[0]}), y({a[1], b[1], c[1], d[1]}),
        z({a[2], b[2], c[2], d[2]});
    ExactSum sum = sum_for(x.values, y.values, z.values);
    add_determinant(sum, x.values, y.values, z.values, 1, 2, 3);
    if (!(x.from_first && y.from_first && z.from_first)) {
        // det(b, c, d) - det(a, c, d) + det(a, b, d) - det(a, b, c), by exchanges of rows.
        add_determinant(sum, x.values, y.values, z.values, 2, 0, 3);
        add_determinant(sum, x.values, y.values, z.values, 0, 1, 3);
        add_determinant(sum, x.values, y.values, z.values, 1, 0, 2);
    }
    return read(sum);
}

// Whether no sum is needed to see that points are coplanar.
bool plainly_coplanar(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    for (int i = 0; i < 3; ++i)
        if (a[i] == b[i] && a[i] == c[i] && a[i] == d[i]) return true;
    return a == b || a == c || a == d || b == c || b == d || c == d;
}

const auto sign_of = [](const ExactSum& sum) { return sum.sign(); };
const auto value_of = [](const ExactSum& sum) { return sum.value(); };

struct PlaneAxes {
    int x, y;
};
PlaneAxes across(int axis) { return {(axis + 1) % 3, (axis + 2) % 3}; }

// The same for the component `axis` of (b - a) x (c - a).
template <class Read>
auto determinant2d(const Vec3& a, const Vec3& b, const Vec3& c, int axis, Read read) {
    const PlaneAxes p = across(axis);
    const Column<3> x({a[p.x], b[p.x], c[p.x]}), y({a[p.y], b[p.y], c[p.y]});
    const Dyadic one(1);
    const std::array<Dyadic, 3> ones{one, one, one};
    ExactSum sum = sum_for(x.values, y.values, ones);
    add_determinant(sum, x.values, y.values, ones, 0, 1, 2);
    return read(sum);
}

}  // namespace

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int side = PlaneFilter(a, b, c).side(d);
    return side != 0 ? side : orient3d_exact(a, b, c, d);
}

int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
    // As in PlaneFilter, with 4 roundings a term.
    constexpr double relative_error = 6 * 0x1p-53;
    const PlaneAxes p = across(axis);
    const double left = (b[p.x] - a[p.x]) * (c[p.y] - a[p.y]),
                 right = (b[p.y] - a[p.y]) * (c[p.x] - a[p.x]);
    const double determinant = left - right;
    const double bound =
        relative_error * (std::abs(left) + std::abs(right)) + PlaneFilter::underflow;
    if (determinant > bound) return 1;
    if (determinant < -bound) return -1;
    return orient2d_exact(a, b, c, axis);
}

int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return plainly_coplanar(a, b, c, d) ? 0 : determinant3d(a, b, c, d, sign_of);
}

int orient2d_exact(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
    return a == b || a == c || b == c ? 0 : determinant2d(a, b, c, axis, sign_of);
}

ScaledDouble orient3d_value(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return determinant3d(a, b, c, d, value_of);
}

ScaledDouble orient2d_value(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
    return determinant2d(a, b, c, axis, value_of);
}

}  // namespace scb
