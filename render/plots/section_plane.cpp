#include "render/plots/section_plane.h"

#include <cmath>
#include <vector>

namespace scb::render {
namespace {

/// The direction's part across `up`, normalized; zero if the two are nearly parallel.
Vec3 across(const Vec3& up, const Vec3& direction) {
    const double length = std::sqrt(squared_norm(direction));
    if (!(length > 0)) return Vec3::Zero();
    Vec3 part = direction / length;
    part -= dot(up, part) * up;
    if (!(squared_norm(part) > 1e-12)) return Vec3::Zero();
    part /= std::sqrt(squared_norm(part));
    // Once more: the difference above has few digits if the two are nearly parallel.
    part -= dot(up, part) * up;
    return part / std::sqrt(squared_norm(part));
}

/// A direction, and its name.
struct Named {
    std::string name;
    Vec3 direction = Vec3::Zero();
};

Named normal_of(const AnyVolume& volume, const char* name) {
    const Scb* s = std::get_if<Scb>(&volume);
    return {name, s != nullptr ? s->n : Vec3(Vec3::Zero())};
}

}  // namespace

bool is_cut(const AnyVolume& volume) {
    return std::holds_alternative<Scb>(volume) || std::holds_alternative<Ball>(volume);
}

SectionPlane section_plane(const AnyVolume& a, const AnyVolume& b, const OverlapStep& step,
                           const std::optional<Vec3>& common_point) {
    const Vec3 to_b = center(b) - center(a);
    const Named line{"the line of centers", to_b}, n0 = normal_of(a, "n0"), n1 = normal_of(b, "n1");
    // Whether the plane goes through B's center; for slab and ball, it goes through the ball's.
    bool through_b = false, silhouettes = !is_cut(a);
    Named own = line;
    std::vector<Named> others;
    switch (step.stage) {
        case Stage::slab_ball:
            own = n0;
            through_b = true;
            others = {line, n1};
            break;
        case Stage::ball_slab:
            own = n1;
            others = {line, n0};
            break;
        case Stage::slab_a:
        case Stage::slab_cylinder:
            own = n0;
            others = {n1, line};
            silhouettes = true;
            break;
        case Stage::slab_b:
        case Stage::cylinder_slab:
            own = n1;
            others = {n0, line};
            silhouettes = true;
            break;
        default:
            others = silhouettes ? std::vector{line} : std::vector{n0, n1};
    }
    if (common_point && !silhouettes)
        others.insert(others.begin(), {"the point of both",
                                       through_b ? Vec3(*common_point - to_b) : *common_point});

    SectionPlane plane;
    plane.up = step.direction / std::sqrt(squared_norm(step.direction));
    plane.right = across(plane.up, std::abs(plane.up[0]) < 0.6 ? Vec3::UnitX() : Vec3::UnitY());
    const bool of_line = own.name == line.name;
    plane.words = of_line ? "cut by a plane through both centers" : "cut by a plane of " + own.name;
    for (const Named& other : others) {
        const Vec3 right = across(plane.up, other.direction);
        if (right == Vec3::Zero()) continue;
        plane.right = right;
        plane.words = silhouettes && other.name != line.name
                          ? "as seen along n0 × n1"
                          : "cut by the plane of " + (of_line ? other.name : own.name) + " and " +
                                (of_line ? own.name : other.name);
        break;
    }
    if (!is_cut(a)) plane.words = "as seen from the side";
    // B is on the right, unless it is straight above.
    if (dot(plane.right, to_b) < 0) plane.right = -plane.right;
    plane.front = cross(plane.right, plane.up);
    // Smaller values are rounding.
    const double behind = -dot(plane.front, to_b);
    if (silhouettes || !(std::abs(behind) > 1e-9 * std::sqrt(squared_norm(to_b)))) return plane;
    (through_b ? plane.before_a : plane.before_b) = through_b ? -behind : behind;
    return plane;
}

}  // namespace scb::render
