#pragma once

#include <cmath>

#include "scb/obb.h"
#include "scb/scb2.h"

namespace scb {

/// Calls visit(d) with the unit normals of the faces of either box, and the unit directions across
/// an edge of each. One of them separates two disjoint boxes (Gottschalk, Lin and Manocha,
/// "OBBTree", Section 5). Parallel edges add no direction.
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

/// The free room that a volume contains about a point: a box and a ball.
struct BoxRoom {
    Obb box;
    double ball = 0;
    double outside = 0;  ///< how far the volume must move to contain the point
};

/// The box about the point inside the volume, with the volume's axes. In a box it is the largest
/// one; in a cut ball, a box that fits into the ball about the point. `from_center` is the point
/// from the volume's center.
BoxRoom room_about(const Obb& box, const Vec3& from_center);
BoxRoom room_about(const Scb2& scb, const Vec3& from_center);

/// A lower bound of how far two volumes with this room about a common point must move apart until
/// they no longer overlap: from the two boxes, or from the two balls.
double depth_of(const BoxRoom& a, const BoxRoom& b);

}  // namespace scb
