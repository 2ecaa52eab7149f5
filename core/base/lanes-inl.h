// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_LANES_INL_H_
#undef SCB_CORE_LANES_INL_H_
#else
#define SCB_CORE_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "scb/vec.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// How many of `count` lanes are computed at a time.
template <class T = float>
constexpr int part_lanes(int count) {
    return count < int{HWY_LANES(T)} ? count : int{HWY_LANES(T)};
}

/// The lowest bits, 32 at most.
constexpr std::uint32_t low_bits(std::uint32_t count) {
    return static_cast<std::uint32_t>((std::uint64_t{1} << count) - 1);
}

/// n floats in one vector, or doubles. Every operation is one rounding in each lane, so that
/// results are the same bits on every target.
template <int n, class T = float>
struct Lanes {
    using D = hn::FixedTag<T, n>;
    hn::Vec<D> v;

    static HWY_INLINE Lanes all(T x) { return {hn::Set(D(), x)}; }
    /// From any address.
    static HWY_INLINE Lanes load(const T* from) { return {hn::LoadU(D(), from)}; }
    /// Whole numbers from any address.
    static HWY_INLINE Lanes load(const std::int16_t* from) requires std::is_same_v<T, float> {
        return load_integers(from);
    }
    static HWY_INLINE Lanes load(const std::uint16_t* from) requires std::is_same_v<T, float> {
        return load_integers(from);
    }
    HWY_INLINE void store(T* to) const { hn::StoreU(v, D(), to); }

    HWY_INLINE T smallest() const { return hn::GetLane(hn::MinOfLanes(D(), v)); }
    HWY_INLINE T largest() const { return hn::GetLane(hn::MaxOfLanes(D(), v)); }

    friend HWY_INLINE Lanes operator+(Lanes a, Lanes b) { return {hn::Add(a.v, b.v)}; }
    friend HWY_INLINE Lanes operator-(Lanes a, Lanes b) { return {hn::Sub(a.v, b.v)}; }
    friend HWY_INLINE Lanes operator*(Lanes a, Lanes b) { return {hn::Mul(a.v, b.v)}; }
    friend HWY_INLINE Lanes operator/(Lanes a, Lanes b) { return {hn::Div(a.v, b.v)}; }
    friend HWY_INLINE Lanes operator-(Lanes a) { return {hn::Neg(a.v)}; }
    friend HWY_INLINE Lanes abs(Lanes a) { return {hn::Abs(a.v)}; }
    friend HWY_INLINE Lanes sqrt(Lanes a) { return {hn::Sqrt(a.v)}; }
    friend HWY_INLINE Lanes max(Lanes a, Lanes b) { return {hn::Max(a.v, b.v)}; }
    friend HWY_INLINE Lanes min(Lanes a, Lanes b) { return {hn::Min(a.v, b.v)}; }

  private:
    template <class Integer>
    static HWY_INLINE Lanes load_integers(const Integer* from) {
        const hn::FixedTag<Integer, n> narrow;
        const hn::FixedTag<std::int32_t, n> wide;
        return {hn::ConvertTo(D(), hn::PromoteTo(wide, hn::LoadU(narrow, from)))};
    }
};

/// A truth value for each of n lanes.
template <int n, class T = float>
struct LaneMask {
    using D = typename Lanes<n, T>::D;
    hn::Mask<D> v;

    friend HWY_INLINE LaneMask operator&(LaneMask a, LaneMask b) { return {hn::And(a.v, b.v)}; }
    friend HWY_INLINE LaneMask operator|(LaneMask a, LaneMask b) { return {hn::Or(a.v, b.v)}; }
    friend HWY_INLINE LaneMask operator^(LaneMask a, LaneMask b) { return {hn::Xor(a.v, b.v)}; }
    friend HWY_INLINE LaneMask operator!(LaneMask a) { return {hn::Not(a.v)}; }

    /// Lane i as bit i.
    HWY_INLINE std::uint32_t bits() const {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(D(), v, bytes);
        std::uint32_t some;
        std::memcpy(&some, bytes, sizeof some);
        return some;
    }
};

template <int n, class T>
HWY_INLINE LaneMask<n, T> operator<=(Lanes<n, T> a, Lanes<n, T> b) {
    return {hn::Le(a.v, b.v)};
}
template <int n, class T>
HWY_INLINE LaneMask<n, T> operator<(Lanes<n, T> a, Lanes<n, T> b) {
    return {hn::Lt(a.v, b.v)};
}
template <int n, class T>
HWY_INLINE LaneMask<n, T> operator==(Lanes<n, T> a, Lanes<n, T> b) {
    return {hn::Eq(a.v, b.v)};
}
template <int n, class T>
HWY_INLINE Lanes<n, T> select(LaneMask<n, T> mask, Lanes<n, T> yes, Lanes<n, T> no) {
    return {hn::IfThenElse(mask.v, yes.v, no.v)};
}

#if HWY_TARGET > HWY_AVX3
/// For each set of bits: the source of each of n lanes when the chosen lanes move to the front.
template <int n>
struct ChosenFrom {
    alignas(32) std::int32_t lane[1 << n][n] = {};
    constexpr ChosenFrom() {
        for (int bits = 0; bits < 1 << n; ++bits)
            for (int k = 0, to = 0; k < n; ++k)
                if ((bits >> k & 1) != 0) lane[bits][to++] = k;
    }
};
template <int n>
inline constexpr ChosenFrom<n> chosen_from{};
#endif

/// Moves the lanes whose bits are set to the front; the lanes behind them are arbitrary. Highway's
/// CompressBits copies its table to the stack for each call in version 1.0.3, and its
/// CompressBitsStore takes a hundred cycles on Zen 4 and 5.
template <int n>
class ChosenLanes {
  public:
    explicit HWY_INLINE ChosenLanes(std::uint32_t bits)
#if HWY_TARGET > HWY_AVX3
        : from_(hn::SetTableIndices(hn::FixedTag<float, n>(), chosen_from<n>.lane[bits])){}
#else
        : mask_(hn::LoadMaskBits(hn::FixedTag<float, n>(), bytes_of(bits).b)) {
    }
#endif

          template <class V>
          HWY_INLINE V
          operator()(V lanes) const {
#if HWY_TARGET > HWY_AVX3
        return hn::TableLookupLanes(lanes, from_);
#else
        return hn::Compress(lanes, hn::RebindMask(hn::DFromV<V>(), mask_));
#endif
    }

  private:
#if HWY_TARGET > HWY_AVX3
    decltype(hn::SetTableIndices(hn::FixedTag<float, n>(), chosen_from<n>.lane[0])) from_;
#else
    struct Bytes {
        std::uint8_t b[8];
    };
    static HWY_INLINE Bytes bytes_of(std::uint32_t bits) {
        Bytes bytes = {};
        std::memcpy(bytes.b, &bits, sizeof bits);
        return bytes;
    }
    hn::Mask<hn::FixedTag<float, n> > mask_;
#endif
};

/// Stores the numbers, of `count`, whose bits are set. Up to `count` elements of `to` are
/// overwritten.
template <int count>
HWY_INLINE void store_chosen(const std::uint32_t* numbers, std::uint32_t bits, std::uint32_t* to) {
    constexpr int n = part_lanes(count);
    const hn::FixedTag<float, n> d;
    const hn::FixedTag<std::uint32_t, n> whole;
    for (int p = 0; p < count; p += n) {
        const std::uint32_t some = (bits >> p) & low_bits(n);
        const auto lanes = hn::BitCast(d, hn::LoadU(whole, numbers + p));
        hn::StoreU(hn::BitCast(whole, ChosenLanes<n>(some)(lanes)), whole, to);
        to += std::popcount(some);
    }
}

/// Three coordinates in n lanes.
template <int n, class T = float>
struct Lanes3 {
    using Number = Lanes<n, T>;
    Number x, y, z;

    static HWY_INLINE Lanes3 all(const T* from) {
        return {Number::all(from[0]), Number::all(from[1]), Number::all(from[2])};
    }
    static HWY_INLINE Lanes3 all(const Vec3& p) requires std::is_same_v<T, double> {
        return all(p.data());
    }
    friend HWY_INLINE Lanes3 operator+(Lanes3 a, Lanes3 b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend HWY_INLINE Lanes3 operator-(Lanes3 a, Lanes3 b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend HWY_INLINE Lanes3 operator-(Lanes3 a) { return {-a.x, -a.y, -a.z}; }
    // In the order of operations of vec.h.
    friend HWY_INLINE Number dot(Lanes3 a, Lanes3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend HWY_INLINE Lanes3 cross(Lanes3 a, Lanes3 b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    /// The largest magnitude of a coordinate.
    friend HWY_INLINE Number largest(Lanes3 a) { return max(max(abs(a.x), abs(a.y)), abs(a.z)); }
};

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
