#pragma once

#include <cmath>

#include "scb/obb.h"
#include "scb/scb2.h"

namespace scb {

/// Calls visit(d) with the unit directions across the faces of either box and across an edge of
/// each, of which one separates two disjoint boxes (Gottschalk, Lin and Manocha, "OBBTree", Section
/// 5); not where two edges are parallel, which adds none.
template <class Visit>
void visit_box_directions(const Obb& a, const Obb& b, const Visit& visit) {
    for (int i = 0; i < 3; ++i) {
        visit(Vec3(a.axes.col(i)));
        visit(Vec3(b.axes.col(i)));
        for (int j = 0; j < 3; ++j) {
            const Vec3 across = cross(Vec3(a.axes.col(i)), Vec3(b.axes.col(j)));
            const double length = std::sqrt(squared_norm(across));
            if (length > 1e-9) visit(Vec3(across / length));
        }
    }
}

/// What a volume holds about a point: a box and a ball.
struct BoxRoom {
    Obb box;
    double ball = 0;
    double outside = 0;  ///< how far the volume must move to hold the point
};

/// The box about the point that the volume holds, with the volume's axes: that of a box is the
/// largest; that of a cut ball one that fits into the ball about the point. `from_center` is the
/// point from the volume's center.
BoxRoom room_about(const Obb& box, const Vec3& from_center);
BoxRoom room_about(const Scb2& scb, const Vec3& from_center);

/// How far two volumes that hold this about a common point must move apart, at least, until they no
/// longer overlap: two boxes, or two balls.
double depth_of(const BoxRoom& a, const BoxRoom& b);

}  // namespace scb
