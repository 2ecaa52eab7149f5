#include "core/packed/displacement.h"

#include <cmath>

namespace scb {

double displacement_bound(const Pose& from, const Pose& to, const Ball& body) {
    // A point c + d moves by (R1 c + t1 - R0 c - t0) + (R1 - R0) d. For rotations, R1 - R0 is (Q -
    // I) R0 with Q their quotient, a turn by some angle: its singular values are 0 and twice 2
    // sin(angle / 2), so it stretches d by its Frobenius norm over sqrt(2) at most.
    //
    // If |R^T R - I| <= defect in each entry, singular values differ from 1 by 3 defect. The matrix
    // differs from a rotation by 3 defect in how far it stretches d, and by 3 sqrt(3) defect in the
    // Frobenius norm: (3 + 3 sqrt(3 / 2)) defect for each matrix, below 7.
    double squares = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double difference = to.rotation(i, j) - from.rotation(i, j);
            squares += difference * difference;
        }
    const double defects = rigidity_defect(from) + rigidity_defect(to);
    const double turn = std::sqrt(squares / 2) + 7 * defects;
    const Vec3 center = body.center;
    const double moved =
        std::sqrt(squared_norm(transform_point(to, center) - transform_point(from, center)));
    // Images of the center are off by a few units in the last place of their terms, entries of the
    // difference by half a unit of 1: 32 units are more than twice the sum of these errors.
    const double lengths = 2 * std::sqrt(squared_norm(center)) + 2 * body.radius +
                           std::sqrt(squared_norm(from.translation)) +
                           std::sqrt(squared_norm(to.translation));
    return moved + turn * body.radius + 32 * 0x1p-53 * lengths;
}

}  // namespace scb
