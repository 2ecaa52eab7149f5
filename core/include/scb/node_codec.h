#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

#include "scb/packed_scb.h"
#include "scb/packed_scb2.h"

namespace scb {

/// How the volumes of a wide node's children are stored: a structure of arrays of `width` volumes,
/// relative to the center of the node's own volume. A codec is for one type of volume. It has
/// `encode`, `decode` and the arrays that kernels read; see load_children. Kernels compute with
/// exactly the decoded volumes.

/// As floats.
template <int width, class V = Scb>
struct FloatCodec;

/// As 16-bit numbers, times one power of two for centers and radii and others for slabs (an SCB of
/// Section 1.1 has 26 bytes: floats, except for the slab). Components of normals and quaternions
/// are in units of 2^-15.
template <int width, class V = Scb>
struct QuantizedCodec;

/// 36 bytes for each: 9 floats.
template <int width_>
struct FloatCodec<width_, Scb> {
    /// The type of encoded volumes.
    using Volume = Scb;
    /// The type of decoded volumes.
    using Decoded = PackedScb;
    /// How many volumes it holds.
    static constexpr int width = width_;
    float c[3][width],  ///< centers
        r[width],       ///< radii
        n[3][width],    ///< normals
        m[width],       ///< middles of the slabs
        h[width];       ///< half thicknesses of the slabs

    /// Stores the volumes, at most `width`, in the frame of `origin`; zeros behind them.
    void encode(std::span<const Scb> volumes, const Vec3& origin);
    /// The i-th volume as it is stored; contains the encoded one.
    PackedScb decode(std::size_t i) const;
};

/// 44 bytes for each: 11 floats.
template <int width_>
struct FloatCodec<width_, Scb2> {
    /// The type of encoded volumes.
    using Volume = Scb2;
    /// The type of decoded volumes.
    using Decoded = PackedScb2;
    /// How many volumes it holds.
    static constexpr int width = width_;
    float c[3][width],  ///< centers
        r[width],       ///< radii
        q[3][width],    ///< quaternions
        m[2][width],    ///< middles of the slabs
        h[2][width];    ///< half thicknesses of the slabs

    /// Stores the volumes, at most `width`, in the frame of `origin`; zeros behind them.
    void encode(std::span<const Scb2> volumes, const Vec3& origin);
    /// The i-th volume as it is stored; contains the encoded one.
    PackedScb2 decode(std::size_t i) const;
};

/// 18 bytes for each.
template <int width_>
struct QuantizedCodec<width_, Scb> {
    /// The type of encoded volumes.
    using Volume = Scb;
    /// The type of decoded volumes.
    using Decoded = PackedScb;
    /// How many volumes it holds.
    static constexpr int width = width_;
    std::int16_t c[3][width],  ///< centers, in units of `length_unit`
        n[3][width],           ///< normals, in units of `direction_unit`
        m[width];              ///< middles of the slabs, in units of `slab_unit`
    std::uint16_t r[width],    ///< radii, in units of `length_unit`
        h[width];              ///< half thicknesses of the slabs, in units of `slab_unit`
    float length_unit,         ///< a power of two
        slab_unit;             ///< a power of two

    /// Stores the volumes, at most `width`, in the frame of `origin`; zeros behind them.
    void encode(std::span<const Scb> volumes, const Vec3& origin);
    /// The i-th volume as it is stored; contains the encoded one.
    PackedScb decode(std::size_t i) const;
};

/// 22 bytes for each: a quaternion has three numbers, as a normal has.
template <int width_>
struct QuantizedCodec<width_, Scb2> {
    /// The type of encoded volumes.
    using Volume = Scb2;
    /// The type of decoded volumes.
    using Decoded = PackedScb2;
    /// How many volumes it holds.
    static constexpr int width = width_;
    std::int16_t c[3][width],  ///< centers, in units of `length_unit`
        q[3][width],           ///< quaternions, in units of `direction_unit`
        m[2][width];           ///< middles of the slabs, in units of `slab_unit`
    std::uint16_t r[width],    ///< radii, in units of `length_unit`
        h[2][width];           ///< half thicknesses of the slabs, in units of `slab_unit`
    float length_unit,         ///< a power of two
        slab_unit[2];          ///< a power of two for each slab

    /// Stores the volumes, at most `width`, in the frame of `origin`; zeros behind them.
    void encode(std::span<const Scb2> volumes, const Vec3& origin);
    /// The i-th volume as it is stored; contains the encoded one.
    PackedScb2 decode(std::size_t i) const;
};

/// The unit of the components of quantized normals and quaternions.
inline constexpr float direction_unit = 0x1p-15f;

/// A variant of T<Codec> over all codecs.
template <template <class> class T>
using AnyCodec =
    std::variant<T<FloatCodec<2>>, T<FloatCodec<4>>, T<FloatCodec<8>>, T<QuantizedCodec<2>>,
                 T<QuantizedCodec<4>>, T<QuantizedCodec<8>>, T<FloatCodec<2, Scb2>>,
                 T<FloatCodec<4, Scb2>>, T<FloatCodec<8, Scb2>>, T<QuantizedCodec<2, Scb2>>,
                 T<QuantizedCodec<4, Scb2>>, T<QuantizedCodec<8, Scb2>>>;

}  // namespace scb
