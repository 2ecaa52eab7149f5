#include "core/distance/precise_features.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/double_double.h"

namespace scb {
namespace {

using Real = DoubleDouble;
using Point = std::array<Real, 3>;
using Weights = std::array<Real, 3>;

Point minus(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
Point plus(const Point& p, const Real& share, const Point& v) {
    return {p[0] + share * v[0], p[1] + share * v[1], p[2] + share * v[2]};
}
Real product(const Point& p, const Point& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Point normal_of(const Point& p, const Point& q) {
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// A triangle, moved, and scaled by a power of two: squares of its sides stay in the range of
/// numbers.
using Triangle3 = std::array<Point, 3>;

/// Measures the pairs of features of two triangles.
class FeatureSearch {
  public:
    FeatureSearch(const Triangle3& a, const Triangle3& b) : a_(a), b_(b) {}

    std::vector<PreciseFeatures> closest_first() {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                add(unit(i), unit(j), minus(b_[j], a_[i]));
                corner_and_edge(a_[i], b_, j, [&](const Weights& of_b, const Point& between) {
                    add(unit(i), of_b, between);
                });
                corner_and_edge(b_[i], a_, j, [&](const Weights& of_a, const Point& between) {
                    add(of_a, unit(i), minus(Point{}, between));
                });
                edges(i, j);
            }
            corner_and_face(a_[i], b_, [&](const Weights& of_b, const Point& between) {
                add(unit(i), of_b, between);
            });
            corner_and_face(b_[i], a_, [&](const Weights& of_a, const Point& between) {
                add(of_a, unit(i), minus(Point{}, between));
            });
        }
        std::stable_sort(found_.begin(), found_.end(), [](const Measured& x, const Measured& y) {
            return x.squared < y.squared;
        });
        std::vector<PreciseFeatures> result;
        for (const Measured& measured : found_) result.push_back(measured.features);
        return result;
    }

  private:
    struct Measured {
        Real squared;  ///< distance
        PreciseFeatures features;
    };

    static Weights unit(std::size_t corner) {
        Weights weights;
        weights[corner] = 1;
        return weights;
    }
    static bool are_inside(const Weights& weights) {
        return std::none_of(weights.begin(), weights.end(),
                            [](const Real& weight) { return !(weight.high >= 0); });
    }
    static std::array<double, 3> rounded(const std::array<Real, 3>& values) {
        return {values[0].high, values[1].high, values[2].high};
    }

    /// `between`: from the point of A to the point of B.
    void add(const Weights& of_a, const Weights& of_b, const Point& between) {
        if (!are_inside(of_a) || !are_inside(of_b)) return;
        const std::array<double, 3> d = rounded(between);
        found_.push_back(
            {product(between, between), {rounded(of_a), rounded(of_b), Vec3(d[0], d[1], d[2])}});
    }

    template <class Add>
    static void corner_and_edge(const Point& p, const Triangle3& t, std::size_t k, const Add& add) {
        const std::size_t next = (k + 1) % 3;
        const Point along = minus(t[next], t[k]), w = minus(p, t[k]);
        const Real squared = product(along, along);
        if (!(squared.high > 0)) return;
        const Real share = product(w, along) / squared;
        Weights weights;
        weights[k] = Real(1) - share;
        weights[next] = share;
        add(weights, plus(minus(t[k], p), share, along));
    }

    /// Apart along the product of the edges, which stays precise where they are nearly parallel.
    void edges(std::size_t i, std::size_t j) {
        const std::size_t after_i = (i + 1) % 3, after_j = (j + 1) % 3;
        const Point u = minus(a_[after_i], a_[i]), v = minus(b_[after_j], b_[j]),
                    w = minus(b_[j], a_[i]), n = normal_of(u, v);
        const Real squared = product(n, n);
        if (!(squared.high > 0)) return;
        // Where nearly parallel edges are closest is inexact. Not so the second point: it is the
        // foot of the first.
        const Real of_u = product(n, normal_of(w, v)) / squared;
        const Point to_first = plus(minus(Point{}, w), of_u, u);
        const Real of_v = product(to_first, v) / product(v, v);
        Weights weights_a, weights_b;
        weights_a[i] = Real(1) - of_u;
        weights_a[after_i] = of_u;
        weights_b[j] = Real(1) - of_v;
        weights_b[after_j] = of_v;
        add(weights_a, weights_b, plus(Point{}, product(n, w) / squared, n));
    }

    template <class Add>
    static void corner_and_face(const Point& p, const Triangle3& t, const Add& add) {
        const Point u = minus(t[1], t[0]), v = minus(t[2], t[0]), w = minus(p, t[0]),
                    n = normal_of(u, v);
        const Real squared = product(n, n);
        if (!(squared.high > 0)) return;
        Weights weights;
        Point rest = w;
        for (int step = 0; step < 2; ++step) {  // twice: the normal of a needle is inexact
            weights[1] = weights[1] + product(n, normal_of(rest, v)) / squared;
            weights[2] = weights[2] + product(n, normal_of(u, rest)) / squared;
            rest = plus(plus(w, -weights[1], u), -weights[2], v);
        }
        weights[0] = Real(1) - weights[1] - weights[2];
        add(weights, plus(Point{}, -(product(n, w) / squared), n));
    }

    const Triangle3 &a_, &b_;
    std::vector<Measured> found_;
};

}  // namespace

std::vector<PreciseFeatures> precise_features(const TriangleCorners& a, const TriangleCorners& b) {
    const Vec3& origin = a[0];
    double most = 0;
    for (const TriangleCorners* t : {&a, &b})
        for (const Vec3& p : *t) most = std::max(most, (p - origin).cwiseAbs().maxCoeff());
    int exponent = 0;
    std::frexp(most, &exponent);
    const auto scaled = [&](const TriangleCorners& t) {
        Triangle3 result;
        for (std::size_t i = 0; i < 3; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                Real x = Real::sum(t[i][axis], -origin[axis]);
                x.high = std::ldexp(x.high, -exponent);
                x.low = std::ldexp(x.low, -exponent);
                result[i][static_cast<std::size_t>(axis)] = x;
            }
        return result;
    };
    const Triangle3 scaled_a = scaled(a), scaled_b = scaled(b);
    return FeatureSearch(scaled_a, scaled_b).closest_first();
}

}  // namespace scb
