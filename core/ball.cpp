#include "core/ball.h"

#include <numbers>

namespace scb {

double surface_area(const Ball& ball) { return 4 * std::numbers::pi * ball.radius * ball.radius; }

double volume(const Ball& ball) {
    return 4 * std::numbers::pi / 3 * ball.radius * ball.radius * ball.radius;
}

bool contains(const Ball& ball, const Vec3& point) {
    return squared_norm(point - ball.center) <= ball.radius * ball.radius;
}

double extent(const Ball& ball, const Vec3&) { return ball.radius; }

}  // namespace scb
