// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_PACKED_AXES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_PACKED_AXES_INL_H_
#undef SCB_CORE_PACKED_AXES_INL_H_
#else
#define SCB_CORE_PACKED_AXES_INL_H_
#endif

#include <hwy/highway.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// The axes of a PackedScb2: first normal, second normal, long axis.
template <class T>
struct PackedAxes {
    T axis[3][3];
};

/// The columns of the matrix of its quaternion. T is a float or lanes of floats, with the same
/// operations.
template <class T>
HWY_INLINE PackedAxes<T> packed_axes(T x, T y, T z, T one) {
    using std::sqrt;
    const T w = sqrt(one - (x * x + y * y + z * z));
    const T x2 = x + x, y2 = y + y, z2 = z + z;
    const T xx = x * x2, xy = x * y2, xz = x * z2, yy = y * y2, yz = y * z2, zz = z * z2,
            wx = w * x2, wy = w * y2, wz = w * z2;
    return {{{one - (yy + zz), xy + wz, xz - wy},
             {xy - wz, one - (xx + zz), yz + wx},
             {xz + wy, yz - wx, one - (xx + yy)}}};
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
