#include "scb/obb.h"

#include <cmath>

#include "scb/pose.h"

namespace scb {

double surface_area(const Obb& box) {
    const Vec3& h = box.half;
    return 8 * (h[0] * h[1] + h[1] * h[2] + h[2] * h[0]);
}

double volume(const Obb& box) { return 8 * box.half[0] * box.half[1] * box.half[2]; }

bool contains(const Obb& box, const Vec3& point) {
    const Vec3 q = point - box.center;
    for (int i = 0; i < 3; ++i)
        if (!(std::abs(dot(Vec3(box.axes.col(i)), q)) <= box.half[i])) return false;
    return true;
}

bool is_well_formed(const Obb& box) {
    return box.center.allFinite() && box.half.allFinite() && box.half.minCoeff() >= 0 &&
           rigidity_defect({box.axes, box.center}) <= 1e-12;
}

double support(const Obb& box, const Vec3& direction) {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        sum += box.half[i] * std::abs(dot(Vec3(box.axes.col(i)), direction));
    return sum;
}

}  // namespace scb
