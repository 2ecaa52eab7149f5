#include "scb/node_codec.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/packed/grown_slab.h"

namespace scb {
namespace {

/// The smallest power of two that is above `value`, or a normal float.
double unit_above(double value) {
    if (!(value > 0)) return 0x1p-126;
    int exponent = 0;
    std::frexp(value, &exponent);  // it is below 2^exponent
    return std::ldexp(1.0, std::max(exponent, -126));
}

// Kernels treat normals as unit vectors. Rounding changes the length of a quantized normal by up to
// sqrt(3) 2^-16. It is shortened by that much first, since along a normal that is too long, any
// ball would reach farther than its radius. About a normal that is too short, a cylinder reaches
// farther than its radius by the missing share, and its ends are off by twice this share of their
// distance. The normals of a quaternion are unit vectors.
constexpr double normal_shortening = 1 - 0x1p-15, normal_slack = 0x1p-13;

std::int16_t to_int16(double value) {
    return static_cast<std::int16_t>(std::clamp(std::nearbyint(value), -32767.0, 32767.0));
}
std::uint16_t to_uint16_above(double value) { return static_cast<std::uint16_t>(std::ceil(value)); }

/// The unit of centers and radii: radii grow by up to one unit for the center's rounding and one
/// for their own.
template <class V>
double length_unit_for(std::span<const V> volumes, const Vec3& origin) {
    double largest = 0;
    for (const V& volume : volumes)
        largest = std::max({largest, (volume.c - origin).cwiseAbs().maxCoeff() / 32767,
                            (volume.r + blur_of(volume.c, origin)) / 65000});
    return unit_above(largest);
}

/// The unit of some slabs.
template <class Slabs>
double slab_unit_for(const Slabs& slabs, std::size_t count) {
    double thickest = 0;
    for (std::size_t i = 0; i < count; ++i)
        thickest = std::max({thickest, std::abs(slabs[i]->m) / 32767, slabs[i]->h / 65000});
    return unit_above(thickest);
}

float times(int count, float unit) { return static_cast<float>(count) * unit; }

}  // namespace

template <int width>
void FloatCodec<width, Scb>::encode(std::span<const Scb> volumes, const Vec3& origin) {
    *this = {};
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const PackedScb scb = packed(volumes[i], origin);
        for (int k = 0; k < 3; ++k) {
            c[k][i] = scb.c[k];
            n[k][i] = scb.n[k];
        }
        r[i] = scb.r;
        m[i] = scb.m;
        h[i] = scb.h;
    }
}

template <int width>
PackedScb FloatCodec<width, Scb>::decode(std::size_t i) const {
    return {{c[0][i], c[1][i], c[2][i]}, r[i], {n[0][i], n[1][i], n[2][i]}, m[i], h[i]};
}

template <int width>
void FloatCodec<width, Scb2>::encode(std::span<const Scb2> volumes, const Vec3& origin) {
    *this = {};
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const PackedScb2 scb = packed(volumes[i], origin);
        for (int k = 0; k < 3; ++k) {
            c[k][i] = scb.c[k];
            q[k][i] = scb.q[k];
        }
        r[i] = scb.r;
        for (int k = 0; k < 2; ++k) {
            m[k][i] = scb.m[k];
            h[k][i] = scb.h[k];
        }
    }
}

template <int width>
PackedScb2 FloatCodec<width, Scb2>::decode(std::size_t i) const {
    return {{c[0][i], c[1][i], c[2][i]},
            r[i],
            {q[0][i], q[1][i], q[2][i]},
            {m[0][i], m[1][i]},
            {h[0][i], h[1][i]}};
}

template <int width>
void QuantizedCodec<width, Scb>::encode(std::span<const Scb> volumes, const Vec3& origin) {
    *this = {};
    const double length = length_unit_for(volumes, origin);
    length_unit = static_cast<float>(length);

    std::optional<GrownSlab> slabs[width];
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const Scb& scb = volumes[i];
        Vec3 rounded_c, rounded_n;
        for (int k = 0; k < 3; ++k) {
            c[k][i] = to_int16((scb.c[k] - origin[k]) / length);
            n[k][i] = to_int16(scb.n[k] * normal_shortening / static_cast<double>(direction_unit));
            rounded_c[k] = origin[k] + c[k][i] * length;
            rounded_n[k] = n[k][i] * static_cast<double>(direction_unit);
        }
        const MovedBall ball(scb.c, scb.r, rounded_c, origin);
        r[i] = to_uint16_above(ball.r * (1 + normal_slack) / length);
        GrownSlab& slab = slabs[i].emplace(scb.n, scb.e, scb.f, rounded_n, ball);
        slab.h += normal_slack * (std::abs(slab.m) + slab.h);
    }
    const double unit = slab_unit_for(slabs, volumes.size());
    slab_unit = static_cast<float>(unit);
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        m[i] = to_int16(slabs[i]->m / unit);
        h[i] = to_uint16_above(slabs[i]->half_about(m[i] * unit) / unit);
    }
}

template <int width>
PackedScb QuantizedCodec<width, Scb>::decode(std::size_t i) const {
    PackedScb scb;
    for (int k = 0; k < 3; ++k) {
        scb.c[k] = times(c[k][i], length_unit);
        scb.n[k] = times(n[k][i], direction_unit);
    }
    scb.r = times(r[i], length_unit);
    scb.m = times(m[i], slab_unit);
    scb.h = times(h[i], slab_unit);
    return scb;
}

template <int width>
void QuantizedCodec<width, Scb2>::encode(std::span<const Scb2> volumes, const Vec3& origin) {
    *this = {};
    const double length = length_unit_for(volumes, origin);
    length_unit = static_cast<float>(length);

    std::optional<GrownSlab> slabs[2][width];
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const Scb2& scb = volumes[i];
        const TurnedSlabs turned(scb);
        Vec3 rounded;
        for (int k = 0; k < 3; ++k) {
            c[k][i] = to_int16((scb.c[k] - origin[k]) / length);
            q[k][i] = to_int16(turned.q[k] / static_cast<double>(direction_unit));
            rounded[k] = origin[k] + c[k][i] * length;
        }
        const MovedBall ball(scb.c, scb.r, rounded, origin);
        r[i] = to_uint16_above(ball.r / length);
        const std::array<Vec3, 2> n = normals(decode(i));
        for (std::size_t k = 0; k < 2; ++k) {
            const Slab& from = turned.slabs[k];
            slabs[k][i].emplace(from.n, from.e, from.f, n[k], ball);
        }
    }
    for (std::size_t k = 0; k < 2; ++k) {
        const double unit = slab_unit_for(slabs[k], volumes.size());
        slab_unit[k] = static_cast<float>(unit);
        for (std::size_t i = 0; i < volumes.size(); ++i) {
            m[k][i] = to_int16(slabs[k][i]->m / unit);
            h[k][i] = to_uint16_above(slabs[k][i]->half_about(m[k][i] * unit) / unit);
        }
    }
}

template <int width>
PackedScb2 QuantizedCodec<width, Scb2>::decode(std::size_t i) const {
    PackedScb2 scb;
    for (int k = 0; k < 3; ++k) {
        scb.c[k] = times(c[k][i], length_unit);
        scb.q[k] = times(q[k][i], direction_unit);
    }
    scb.r = times(r[i], length_unit);
    for (int k = 0; k < 2; ++k) {
        scb.m[k] = times(m[k][i], slab_unit[k]);
        scb.h[k] = times(h[k][i], slab_unit[k]);
    }
    return scb;
}

template struct FloatCodec<2>;
template struct FloatCodec<4>;
template struct FloatCodec<8>;
template struct QuantizedCodec<2>;
template struct QuantizedCodec<4>;
template struct QuantizedCodec<8>;
template struct FloatCodec<2, Scb2>;
template struct FloatCodec<4, Scb2>;
template struct FloatCodec<8, Scb2>;
template struct QuantizedCodec<2, Scb2>;
template struct QuantizedCodec<4, Scb2>;
template struct QuantizedCodec<8, Scb2>;

}  // namespace scb
