#include <algorithm>
#include <cmath>

#include "core/explain/exact_overlap.h"

namespace scb {

ContactCertificate exact_overlap(const Ball& a, const Ball& b, double tolerance) {
    const double least = tolerance * std::max(a.radius, b.radius);
    const Vec3 to_b = b.center - a.center;
    const double distance = std::sqrt(squared_norm(to_b)), gap = distance - a.radius - b.radius;
    // If the centers coincide, any direction will do.
    const Vec3 direction = distance > 0 ? Vec3(to_b / distance) : Vec3::UnitX();
    ContactCertificate certificate;
    if (gap > least) {
        certificate = {Contact::disjoint, direction, Vec3::Zero(), gap};
    } else if (-gap > least) {
        // On the line of centers, in the middle of the common part of the balls.
        const double from = std::max(-a.radius, distance - b.radius),
                     to = std::min(a.radius, distance + b.radius);
        certificate = {Contact::overlapping, Vec3::Zero(), 0.5 * (from + to) * direction, -gap};
    }
    return certificate;
}

}  // namespace scb
