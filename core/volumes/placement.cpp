#include "scb/placement.h"

#include <algorithm>
#include <cmath>

#include "core/volumes/shape.h"

namespace scb {

Placement placement(const Pose& b_to_a, double reach_a, double reach_b) {
    // A transformed vertex of B is off by at most 4 units in the last place of its distance to A's
    // origin, and so is B's center. B's normal is off by 4 units of 1, at a distance of at most 2
    // reach_b from the center. Dot products, sums and squares of the test add a few units of the
    // same lengths each. 64 units are more than twice the sum of these errors.
    constexpr double unit = 0x1p-53;
    const double lengths = reach_a + reach_b + std::sqrt(squared_norm(b_to_a.translation));
    // A matrix with |R^T R - I| <= defect in each entry stretches and shears by as much: B, and A's
    // distances along B's normal. The square of a normal's length is off by 3 defect, and so is 1
    // minus the square of its cosine.
    const double defect = rigidity_defect(b_to_a);
    return {b_to_a, 64 * unit * lengths + 6 * defect * lengths, 1 + 0x1p-47 + 4 * defect};
}

double reach(const Scb& v) { return std::sqrt(squared_norm(v.c)) + v.r; }
double reach(const Scb2& v) { return std::sqrt(squared_norm(v.c)) + v.r; }
double reach(const Ball& v) { return std::sqrt(squared_norm(v.center)) + v.radius; }
double reach(const Obb& v) {
    return std::sqrt(squared_norm(v.center)) + std::sqrt(squared_norm(v.half));
}
double reach(const Aabb& v) { return reach(shape_of(v)); }
double reach(const ExactAabb& v) { return reach(shape_of(v)); }

}  // namespace scb
