#include "core/geometry/orientation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <climits>
#include <cstddef>
#include <cstdint>
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

__extension__ typedef __int128 Int128;

// The differences of a column as integers times a common power of two. Coordinates that were floats
// give some 30 bits; after a motion, some 53.
template <std::size_t N>
struct IntegerColumn {
    static constexpr int most_bits = 62;

    std::array<std::int64_t, N> values{};
    int bits = 0;  // of the longest; more than most_bits if the values are not set

    explicit IntegerColumn(const Column<N>& column) {
        if (!column.from_first) {
            bits = most_bits + 1;
            return;
        }
        int lowest = INT_MAX, end = INT_MIN;
        for (const Dyadic& v : column.values)
            if (v.mantissa != 0) {
                lowest = std::min(lowest, v.exponent + std::countr_zero(v.mantissa));
                end = std::max(end, v.exponent + static_cast<int>(std::bit_width(v.mantissa)));
            }
        if (end == INT_MIN) return;
        bits = end - lowest;
        if (bits > most_bits) return;
        for (std::size_t i = 0; i < N; ++i) {
            const Dyadic& v = column.values[i];
            if (v.mantissa == 0) continue;
            const int shift = v.exponent - lowest;
            const auto value =
                static_cast<std::int64_t>(shift >= 0 ? v.mantissa << shift : v.mantissa >> -shift);
            values[i] = v.negative ? -value : value;
        }
    }
    bool is_set() const { return bits <= most_bits; }
};

int sign(Int128 x) { return static_cast<int>(x > 0) - static_cast<int>(x < 0); }

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

// The coordinates of four points, for det(b - a, c - a, d - a).
struct Columns3d {
    Column<4> x, y, z;

    Columns3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
        : x({a[0], b[0], c[0], d[0]}), y({a[1], b[1], c[1], d[1]}), z({a[2], b[2], c[2], d[2]}) {}

    // A callback, since the sum is too large to return.
    template <class Read>
    auto determinant(Read read) const {
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

    int sign_of_determinant() const {
        const IntegerColumn<4> u(x), v(y), w(z);
        // Six products, each less than 2^124: their sum is less than 2^127.
        if (!u.is_set() || !v.is_set() || !w.is_set() || u.bits + v.bits + w.bits > 124)
            return determinant([](const ExactSum& sum) { return sum.sign(); });
        const auto minor = [&](std::size_t j, std::size_t k) {
            return Int128{v.values[j]} * w.values[k] - Int128{v.values[k]} * w.values[j];
        };
        return sign(u.values[1] * minor(2, 3) + u.values[2] * minor(3, 1) +
                    u.values[3] * minor(1, 2));
    }
};

// Whether no sum is needed to see that points are coplanar.
bool plainly_coplanar(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    for (int i = 0; i < 3; ++i)
        if (a[i] == b[i] && a[i] == c[i] && a[i] == d[i]) return true;
    return a == b || a == c || a == d || b == c || b == d || c == d;
}

struct PlaneAxes {
    int x, y;
};
PlaneAxes across(int axis) { return {(axis + 1) % 3, (axis + 2) % 3}; }

// Two coordinates of three points, for a component of (b - a) x (c - a).
struct Columns2d {
    Column<3> x, y;

    Columns2d(const Vec3& a, const Vec3& b, const Vec3& c, PlaneAxes p)
        : x({a[p.x], b[p.x], c[p.x]}), y({a[p.y], b[p.y], c[p.y]}) {}

    template <class Read>
    auto determinant(Read read) const {
        const Dyadic one(1);
        const std::array<Dyadic, 3> ones{one, one, one};
        ExactSum sum = sum_for(x.values, y.values, ones);
        add_determinant(sum, x.values, y.values, ones, 0, 1, 2);
        return read(sum);
    }

    int sign_of_determinant() const {
        const IntegerColumn<3> u(x), v(y);
        if (!u.is_set() || !v.is_set())
            return determinant([](const ExactSum& sum) { return sum.sign(); });
        return sign(Int128{u.values[1]} * v.values[2] - Int128{u.values[2]} * v.values[1]);
    }
};

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
    return plainly_coplanar(a, b, c, d) ? 0 : Columns3d(a, b, c, d).sign_of_determinant();
}

int orient2d_exact(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
    return a == b || a == c || b == c ? 0 : Columns2d(a, b, c, across(axis)).sign_of_determinant();
}

ScaledDouble orient3d_value(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return Columns3d(a, b, c, d).determinant([](const ExactSum& sum) { return sum.value(); });
}

ScaledDouble orient2d_value(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
    return Columns2d(a, b, c, across(axis)).determinant([](const ExactSum& sum) {
        return sum.value();
    });
}

}  // namespace scb
