#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

#include "scb/packed_scb.h"

namespace scb {

/// How the volumes of a wide node's children are stored: a structure of arrays of `width` volumes,
/// whose centers are relative to the node's own. A codec has `encode`, `decode` and the arrays that
/// kernels read; see load_children. What it decodes to is exactly what kernels compute with.

/// 36 bytes for each: 9 floats.
template <int width_>
struct FloatCodec {
    static constexpr int width = width_;
    float c[3][width], r[width], n[3][width], m[width], h[width];

    /// Stores the volumes, at most `width`, in the frame of `origin`; zeros behind them.
    void encode(std::span<const Scb> volumes, const Vec3& origin);
    /// The i-th volume as it is stored: it holds the one that was encoded.
    PackedScb decode(std::size_t i) const;
};

/// 18 bytes for each: 16 bits for each component, times one power of two for centers and radii and
/// another for slabs (Section 1.1 has 26 bytes: floats but for the slab). Normals are in units of
/// 2^-15.
template <int width_>
struct QuantizedCodec {
    static constexpr int width = width_;
    std::int16_t c[3][width], n[3][width], m[width];
    std::uint16_t r[width], h[width];
    float length_unit, slab_unit;

    /// See FloatCodec.
    void encode(std::span<const Scb> volumes, const Vec3& origin);
    PackedScb decode(std::size_t i) const;
};

/// What a component of a quantized normal counts in.
inline constexpr float normal_unit = 0x1p-15f;

/// One of T<Codec>, for every codec there is.
template <template <class> class T>
using AnyCodec = std::variant<T<FloatCodec<2>>, T<FloatCodec<4>>, T<FloatCodec<8>>,
                              T<QuantizedCodec<2>>, T<QuantizedCodec<4>>, T<QuantizedCodec<8>>>;

}  // namespace scb
