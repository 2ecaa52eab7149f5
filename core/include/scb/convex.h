#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <span>
#include <vector>

#include "scb/vec.h"

namespace scb {

/// The area of a closed surface, and the volume that it encloses.
struct SurfaceMeasures {
    double area = 0,  ///< in the square of the mesh's unit of length
        volume = 0;   ///< in its cube
};

/// A face of a polytope, whose points p have normal.p <= offset. The normal need not be a unit
/// vector.
struct FacePlane {
    /// Outward.
    Vec3 normal = Vec3::UnitZ();
    /// The distance of the plane from the origin, times the length of the normal.
    double offset = 0;
};

/// A bounding volume given by its farthest points: all points within `rounding` of a convex core.
/// Your own volume needs no more than this, see core/topics/volumes.md, "Your own bounding volume
/// in one header". A plain struct with
/// - `center(v)`: a point in its middle, from which it is measured, in the body's frame;
/// - `support_point(v, d)`: the point of the core, from the center, that is farthest in the
///   direction d, which need not be a unit vector and is not zero. Correct to rounding in every
///   direction, also along the volume's own axes and faces: if it falls short, collisions may be
///   lost;
/// - `rounding(v)`: a length, 0 or more;
/// - `contains(v, p)`: whether a point of the body's frame is inside or on the surface. True for
///   all points that the volume was fitted to, with the rounding of this function;
/// - `fit(v, points)`, with `points` a FitPoints;
/// - `V::title`, a name for pictures, and `V::support_operations`, what `support_point` costs in
///   additions, multiplications, divisions and roots.
///
/// It may have `measures(v)`, its area and volume in closed form, a SurfaceMeasures; without it, a
/// polytope is measured, and traversals by area or volume use the box. A polytope may have
/// `faces(v)`, a vector of FacePlane from the center: pictures and exported meshes then have these
/// faces. Without it, a volume that is not rounded is drawn as a polytope that touches it in 98
/// directions.
template <class V>
concept ConvexVolume = requires(V& v, const V& c, const Vec3& x) {
    { center(c) } -> std::same_as<Vec3>;
    { support_point(c, x) } -> std::same_as<Vec3>;
    { rounding(c) } -> std::convertible_to<double>;
    { contains(c, x) } -> std::same_as<bool>;
    { V::title } -> std::convertible_to<const char*>;
    { V::support_operations } -> std::convertible_to<unsigned>;
};

/// A radius whose rounded square is no less than `squared`.
inline double radius_of_square(double squared) {
    double radius = std::sqrt(squared);
    while (radius * radius < squared) radius = std::nextafter(radius, HUGE_VAL);
    return radius;
}

// The functions below are the defaults of all convex volumes.

/// How far the volume reaches from its center in the unit direction d.
template <ConvexVolume V>
double support(const V& v, const Vec3& d) {
    return dot(support_point(v, d), d) + rounding(v);
}

/// Half the sides of its box along the axes of the body.
template <ConvexVolume V>
Vec3 half_extents(const V& v) {
    Vec3 result;
    for (int i = 0; i < 3; ++i)
        result[i] = 0.5 * (support(v, Vec3::Unit(i)) + support(v, Vec3(-Vec3::Unit(i))));
    return result;
}

/// The size that decides which of two volumes a traversal descends into: the longest half length of
/// its box.
template <ConvexVolume V>
double descent_size(const V& v) {
    return half_extents(v).maxCoeff();
}
/// Diameter: the diagonal of its box.
template <ConvexVolume V>
double diameter(const V& v) {
    return 2 * std::sqrt(squared_norm(half_extents(v)));
}
/// Thickness: the shortest side of its box.
template <ConvexVolume V>
double thickness(const V& v) {
    return 2 * half_extents(v).minCoeff();
}

/// Whether center, extents and rounding are finite, and the last two not negative.
template <ConvexVolume V>
bool is_well_formed(const V& v) {
    const Vec3 half = half_extents(v);
    return center(v).allFinite() && half.allFinite() && half.minCoeff() >= 0 &&
           std::isfinite(rounding(v)) && rounding(v) >= 0;
}

/// A distance from the origin that no point of the volume exceeds.
template <ConvexVolume V>
double reach(const V& v) {
    Vec3 most;
    for (int i = 0; i < 3; ++i)
        most[i] = std::max(support(v, Vec3::Unit(i)), support(v, Vec3(-Vec3::Unit(i))));
    return std::sqrt(squared_norm(center(v))) + std::sqrt(squared_norm(most));
}

/// The area and volume of the polytope within the planes, face by face, exact up to rounding. The
/// polytope must be within the distance `size` of the origin.
SurfaceMeasures polytope_measures(std::span<const FacePlane> planes, double size);

/// The directions in which a polytope touches the volume that it is drawn and measured for.
std::span<const Vec3> touching_directions();

/// Area and volume: in closed form, or from its faces, or from the polytope that touches it, which
/// is slightly larger.
template <ConvexVolume V>
SurfaceMeasures surface_measures(const V& v) {
    if constexpr (requires { measures(v); }) {
        return measures(v);
    } else {
        std::vector<FacePlane> planes;
        if constexpr (requires { faces(v); })
            planes = faces(v);
        else
            for (const Vec3& d : touching_directions()) planes.push_back({d, support(v, d)});
        return polytope_measures(planes, diameter(v));
    }
}
/// The area of `surface_measures`.
template <ConvexVolume V>
double surface_area(const V& v) {
    return surface_measures(v).area;
}
/// The volume of `surface_measures`.
template <ConvexVolume V>
double volume(const V& v) {
    return surface_measures(v).volume;
}

/// The area and volume that descent rules compare: in closed form, else of the box, since to go
/// through faces at each test would take longer than the test.
template <ConvexVolume V>
SurfaceMeasures descent_measures(const V& v) {
    if constexpr (requires { measures(v); }) {
        return measures(v);
    } else {
        const Vec3 h = half_extents(v);
        return {8 * (h[0] * h[1] + h[1] * h[2] + h[2] * h[0]), 8 * h[0] * h[1] * h[2]};
    }
}

}  // namespace scb
