#include "scb/ball.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace scb {

double surface_area(const Ball& ball) { return 4 * std::numbers::pi * ball.radius * ball.radius; }

double volume(const Ball& ball) {
    return 4 * std::numbers::pi / 3 * ball.radius * ball.radius * ball.radius;
}

bool contains(const Ball& ball, const Vec3& point) {
    return squared_norm(point - ball.center) <= ball.radius * ball.radius;
}

bool is_well_formed(const Ball& ball) {
    return ball.center.allFinite() && std::isfinite(ball.radius) && ball.radius >= 0;
}

double support(const Ball& ball, const Vec3&) { return ball.radius; }

double radius_reaching(double squared_distance) {
    double r = std::sqrt(squared_distance);
    while (r * r < squared_distance) r = std::nextafter(r, std::numeric_limits<double>::infinity());
    return r;
}

}  // namespace scb
