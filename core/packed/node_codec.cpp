#include "scb/node_codec.h"

#include <algorithm>
#include <cmath>

#include "core/packed/grown_scb.h"

namespace scb {
namespace {

/// The smallest power of two of which `most` multiples reach `value`.
double unit_for(double value, double most) {
    if (!(value > 0)) return 0x1p-126;
    int exponent = 0;
    std::frexp(value / most, &exponent);  // value / most is below 2^exponent
    return std::ldexp(1.0, std::max(exponent, -126));
}

// Kernels take normals for unit vectors. Rounding changes the length of a quantized one by up to
// sqrt(3) 2^-16; it is shortened by that much first, since along a longer one any ball would reach
// farther than its radius. About one that is too short, a cylinder reaches farther than its radius
// by the share that is missing, and its ends are off by twice the share of their distance.
constexpr double normal_shortening = 1 - 0x1p-15, normal_slack = 0x1p-13;

std::int16_t to_int16(double value) {
    return static_cast<std::int16_t>(std::clamp(std::nearbyint(value), -32767.0, 32767.0));
}

}  // namespace

template <int width>
void FloatCodec<width>::encode(std::span<const Scb> volumes, const Vec3& origin) {
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
PackedScb FloatCodec<width>::decode(std::size_t i) const {
    return {{c[0][i], c[1][i], c[2][i]}, r[i], {n[0][i], n[1][i], n[2][i]}, m[i], h[i]};
}

template <int width>
void QuantizedCodec<width>::encode(std::span<const Scb> volumes, const Vec3& origin) {
    *this = {};
    // Radii grow by up to one unit for the center's rounding and one for their own.
    double largest = 0;
    for (const Scb& scb : volumes)
        largest = std::max({largest, (scb.c - origin).cwiseAbs().maxCoeff() / 32767,
                            (scb.r + blur_of(scb, origin)) / 65000});
    const double length = unit_for(largest, 1);
    length_unit = static_cast<float>(length);

    GrownScb grown[width];
    double thickest = 0;
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const Scb& scb = volumes[i];
        RoundedCenter rounded{{}, {}, origin};
        for (int k = 0; k < 3; ++k) {
            c[k][i] = to_int16((scb.c[k] - origin[k]) / length);
            n[k][i] = to_int16(scb.n[k] * normal_shortening / static_cast<double>(normal_unit));
            rounded.c[k] = origin[k] + c[k][i] * length;
            rounded.n[k] = n[k][i] * static_cast<double>(normal_unit);
        }
        grown[i] = grown_about(scb, rounded);
        grown[i].r *= 1 + normal_slack;
        grown[i].h += normal_slack * (std::abs(grown[i].m) + grown[i].h);
        r[i] = static_cast<std::uint16_t>(std::ceil(grown[i].r / length));
        thickest = std::max({thickest, std::abs(grown[i].m) / 32767, grown[i].h / 65000});
    }
    const double slab = unit_for(thickest, 1);
    slab_unit = static_cast<float>(slab);
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        m[i] = to_int16(grown[i].m / slab);
        h[i] = static_cast<std::uint16_t>(std::ceil(half_thickness(grown[i], m[i] * slab) / slab));
    }
}

template <int width>
PackedScb QuantizedCodec<width>::decode(std::size_t i) const {
    const auto times = [](auto count, float unit) { return static_cast<float>(count) * unit; };
    PackedScb scb;
    for (int k = 0; k < 3; ++k) {
        scb.c[k] = times(c[k][i], length_unit);
        scb.n[k] = times(n[k][i], normal_unit);
    }
    scb.r = times(r[i], length_unit);
    scb.m = times(m[i], slab_unit);
    scb.h = times(h[i], slab_unit);
    return scb;
}

template struct FloatCodec<2>;
template struct FloatCodec<4>;
template struct FloatCodec<8>;
template struct QuantizedCodec<2>;
template struct QuantizedCodec<4>;
template struct QuantizedCodec<8>;

}  // namespace scb
