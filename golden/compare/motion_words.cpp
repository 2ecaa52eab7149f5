#include "golden/compare/motion_words.h"

#include <algorithm>
#include <cmath>

#include "core/base/text_format.h"

namespace scb::golden {
namespace {

constexpr double degrees_per_radian = 57.29577951308232;
constexpr double rounding = 1e-6;

}  // namespace

std::string motion_words(const Pose& before, const Pose& after) {
    const Vec3 moved = after.translation - before.translation;
    // The matrices of two rotations an angle t apart are 2 sqrt(2) sin(t / 2) apart. Unlike the arc
    // cosine of a trace, this is exact for small angles.
    const double apart = (after.rotation - before.rotation).norm();
    const double angle = 2 * std::asin(std::min(1.0, apart / std::sqrt(8.0)));
    const double largest = std::max(moved.cwiseAbs().maxCoeff(), angle);
    std::string lengths;
    for (int axis = 0; axis < 3; ++axis)
        if (moved[axis] != 0 && std::abs(moved[axis]) > rounding * largest)
            lengths +=
                (lengths.empty() ? "" : ", ") + format("%.4g along ", moved[axis]) + "xyz"[axis];
    std::string turn;
    if (angle != 0 && angle > rounding * largest) turn = format("%.4g", angle * degrees_per_radian);
    if (!turn.empty()) turn += turn == "1" ? " degree" : " degrees";
    if (lengths.empty()) return turn.empty() ? "" : "turned: " + turn;
    return "moved: " + lengths + (turn.empty() ? "" : ", " + turn);
}

}  // namespace scb::golden
