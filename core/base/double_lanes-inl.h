// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_DOUBLE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_DOUBLE_LANES_INL_H_
#undef SCB_CORE_DOUBLE_LANES_INL_H_
#else
#define SCB_CORE_DOUBLE_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <cassert>
#include <cstddef>

#include "scb/vec.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// 2 to 8 doubles in one vector. Every operation is one rounding in each lane, so that results are
/// the same bits on every target.
struct Doubles {
    static constexpr std::size_t n = HWY_LANES(double) < 8 ? HWY_LANES(double) : 8;
    using D = hn::FixedTag<double, n>;
    using Mask = hn::Mask<D>;
    hn::Vec<D> v;

    static HWY_INLINE Doubles all(double x) { return {hn::Set(D(), x)}; }
    /// From an address that is a multiple of the vector's size.
    static HWY_INLINE Doubles load(const double* from) { return {hn::Load(D(), from)}; }
    static HWY_INLINE Doubles load_from_any(const double* from) { return {hn::LoadU(D(), from)}; }
    HWY_INLINE void store(double* to) const { hn::Store(v, D(), to); }

    HWY_INLINE double smallest() const { return hn::GetLane(hn::MinOfLanes(D(), v)); }
    HWY_INLINE double largest() const { return hn::GetLane(hn::MaxOfLanes(D(), v)); }

    friend HWY_INLINE Doubles operator+(Doubles a, Doubles b) { return {hn::Add(a.v, b.v)}; }
    friend HWY_INLINE Doubles operator-(Doubles a, Doubles b) { return {hn::Sub(a.v, b.v)}; }
    friend HWY_INLINE Doubles operator*(Doubles a, Doubles b) { return {hn::Mul(a.v, b.v)}; }
    friend HWY_INLINE Doubles max(Doubles a, Doubles b) { return {hn::Max(a.v, b.v)}; }
    friend HWY_INLINE Doubles min(Doubles a, Doubles b) { return {hn::Min(a.v, b.v)}; }
    friend HWY_INLINE Mask operator<(Doubles a, Doubles b) { return hn::Lt(a.v, b.v); }
    friend HWY_INLINE Mask operator==(Doubles a, Doubles b) { return hn::Eq(a.v, b.v); }
    friend HWY_INLINE Doubles select(Mask mask, Doubles yes, Doubles no) {
        return {hn::IfThenElse(mask, yes.v, no.v)};
    }
};

/// Three coordinates in each lane.
struct Doubles3 {
    Doubles x, y, z;

    static HWY_INLINE Doubles3 all(const Vec3& p) {
        return {Doubles::all(p[0]), Doubles::all(p[1]), Doubles::all(p[2])};
    }
    friend HWY_INLINE Doubles3 operator-(Doubles3 a, Doubles3 b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    // In the order of operations of vec.h.
    friend HWY_INLINE Doubles dot(Doubles3 a, Doubles3 b) {
        return a.x * b.x + a.y * b.y + a.z * b.z;
    }
    friend HWY_INLINE Doubles3 cross(Doubles3 a, Doubles3 b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
};

/// The first index at which a number is that value, which one of them is; a whole number of
/// vectors, from an aligned address.
HWY_INLINE std::size_t first_equal(const double* numbers, std::size_t count, double value) {
    for (std::size_t i = 0; i < count; i += Doubles::n) {
        const auto mask = Doubles::load(numbers + i) == Doubles::all(value);
        if (!hn::AllFalse(Doubles::D(), mask))
            return i + static_cast<std::size_t>(hn::FindFirstTrue(Doubles::D(), mask));
    }
    assert(false && "one of them is");
    return 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
