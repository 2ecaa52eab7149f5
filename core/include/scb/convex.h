#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <span>
#include <vector>

#include "scb/vec.h"

namespace scb {

/// What a surface measures, and what it encloses.
struct SurfaceMeasures {
    double area = 0,  ///< in the square of the mesh's unit of length
        volume = 0;   ///< in its cube
};

/// A face of a polytope: the points p of it have normal.p <= offset. The normal need not be a unit
/// vector.
struct FacePlane {
    /// Points out of the polytope.
    Vec3 normal = Vec3::UnitZ();
    /// Of the plane from the origin, in lengths of the normal.
    double offset = 0;
};

/// A bounding volume that is known by its farthest points: all within `rounding` of a convex core.
/// This is all that a volume of one's own must offer, next to a `fit`; see core/README.md, "Your
/// own bounding volume in one header". A plain struct, and of it:
/// - `center(v)`: a point in its middle, from which it is measured, in the body's frame;
/// - `support_point(v, d)`: the point of the core, from the center, that is farthest in the
///   direction d, which need not be a unit vector and is not zero. Right to rounding in every
///   direction, also along the volume's own axes and faces: what it falls short of, collisions may
///   be lost by;
/// - `rounding(v)`: a length, 0 or more;
/// - `contains(v, p)`: whether a point of the body's frame is inside or on the surface. All points
///   that it was fitted to are, exactly as this rounds;
/// - `fit(v, points)`, with `points` a FitPoints;
/// - `V::title`, a name for pictures, and `V::support_operations`, what `support_point` costs in
///   additions, multiplications, divisions and roots.
///
/// It may have `measures(v)`, its area and volume in closed form, a SurfaceMeasures; without it
/// they are those of a polytope, and traversals by area or volume go by its box. A polytope may
/// have `faces(v)`, a vector of FacePlane from the center: pictures and exported meshes then have
/// its very faces. Without it, what is not rounded is drawn as a polytope that touches it in 98
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

/// A radius whose square, as it is rounded, is no less than this.
inline double radius_of_square(double squared) {
    double radius = std::sqrt(squared);
    while (radius * radius < squared) radius = std::nextafter(radius, HUGE_VAL);
    return radius;
}

// The functions below serve every convex volume that has none of its own.

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

/// Whether all that can be asked of it is finite.
template <ConvexVolume V>
bool is_well_formed(const V& v) {
    const Vec3 half = half_extents(v);
    return center(v).allFinite() && half.allFinite() && half.minCoeff() >= 0 &&
           std::isfinite(rounding(v)) && rounding(v) >= 0;
}

/// The distance from the origin within which the volume is.
template <ConvexVolume V>
double reach(const V& v) {
    Vec3 most;
    for (int i = 0; i < 3; ++i)
        most[i] = std::max(support(v, Vec3::Unit(i)), support(v, Vec3(-Vec3::Unit(i))));
    return std::sqrt(squared_norm(center(v))) + std::sqrt(squared_norm(most));
}

/// The area and volume of the polytope within the planes, face by face, and exact but for rounding;
/// `size` is a length that it does not exceed, about the origin.
SurfaceMeasures polytope_measures(std::span<const FacePlane> planes, double size);

/// The directions in which a polytope touches a volume that stands for it.
std::span<const Vec3> touching_directions();

/// In closed form, or of the polytope that it is, or of the one that touches it, which has a little
/// more.
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

/// What a traversal divides by: area and volume in closed form, else those of the box, since to go
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
