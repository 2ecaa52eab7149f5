#include "scenes/shapes/torus_knot.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/portable_math.h"
#include "scenes/shapes/parameter_checks.h"

namespace scb::scenes {
namespace {

double length(const Vec3& v) { return std::sqrt(squared_norm(v)); }

/// The rate of change of the unit vector v / |v| if v changes at the rate dv.
Vec3 unit_rate(const Vec3& v, const Vec3& dv) {
    const double inverse = 1 / length(v);
    const Vec3 unit = v * inverse;
    return (dv - unit * dot(unit, dv)) * inverse;
}

void check_knot(const TorusKnot& knot) {
    require_between("p", knot.p, 1, 1000);
    require_between("q", knot.q, 1, 1000);
    require_length("major_radius", knot.major_radius);
    require_length("minor_radius", knot.minor_radius);
    require_length("tube_radius", knot.tube_radius);
    require_between("sides", knot.sides, 3, max_procedural_triangles);
    require_between("rings", knot.rings, 3, max_procedural_triangles);
    require_between("offset_turns", knot.offset_turns, -1000, 1000);
    if (!(knot.offset >= 0 && knot.offset <= max_coordinate))
        throw InputError("offset is " + exact_number(knot.offset) + "; give a length from 0 to " +
                         exact_number(max_coordinate) + ".");
    require_triangles(std::int64_t{2} * knot.rings * knot.sides);
}

}  // namespace

KnotFrame knot_frame(const TorusKnot& knot, double turns) {
    // Derivatives are by the angle t in radians.
    const double p = knot.p, q = knot.q, r = knot.minor_radius;
    const SinCos around = sin_cos_turns(p * turns), across = sin_cos_turns(q * turns);
    const Vec3 outward(around.cos, around.sin, 0), d_outward(-p * around.sin, p * around.cos, 0);
    const Vec3 dd_outward = -p * p * outward;
    const Vec3 up = Vec3::UnitZ();

    const double reach = knot.major_radius + r * across.cos;
    const double d_reach = -q * r * across.sin, dd_reach = -q * q * r * across.cos;
    const Vec3 point = reach * outward + r * across.sin * up;
    const Vec3 velocity = d_reach * outward + reach * d_outward + q * r * across.cos * up;
    const Vec3 acceleration = dd_reach * outward + 2 * d_reach * d_outward + reach * dd_outward -
                              q * q * r * across.sin * up;

    const Vec3 torus_normal = across.cos * outward + across.sin * up;
    const Vec3 d_torus_normal =
        -q * across.sin * outward + across.cos * d_outward + q * across.cos * up;
    const Vec3 knot_tangent = velocity / length(velocity);
    const Vec3 side = knot_tangent.cross(torus_normal);
    const Vec3 d_side =
        unit_rate(velocity, acceleration).cross(torus_normal) + knot_tangent.cross(d_torus_normal);

    const double w = knot.offset_turns;
    const SinCos wind = sin_cos_turns(w * turns);
    KnotFrame frame;
    frame.point = point + knot.offset * (wind.cos * torus_normal + wind.sin * side);
    const Vec3 axis_velocity =
        velocity + knot.offset * (-w * wind.sin * torus_normal + wind.cos * d_torus_normal +
                                  w * wind.cos * side + wind.sin * d_side);
    const double speed = length(axis_velocity);
    frame.tangent = axis_velocity / speed;
    const Vec3 away =
        knot.offset > 0 ? Vec3(wind.cos * torus_normal + wind.sin * side) : torus_normal;
    const Vec3 across_tangent = away - frame.tangent * dot(frame.tangent, away);
    const double clearance = length(across_tangent);
    if (!(speed > 1e-6 * length(velocity)) || !(clearance > 1e-3))
        throw InputError(
            "offset is " + exact_number(knot.offset) +
            ", so large that the tube has no cross-section at some places; give a smaller one.");
    frame.normal = across_tangent / clearance;
    frame.binormal = frame.tangent.cross(frame.normal);
    return frame;
}

Mesh torus_knot_mesh(const TorusKnot& knot) {
    check_knot(knot);
    Mesh mesh;
    for (int i = 0; i < knot.rings; ++i) {
        const KnotFrame frame = knot_frame(knot, static_cast<double>(i) / knot.rings);
        for (int j = 0; j < knot.sides; ++j) {
            const SinCos angle = sin_cos_turns((j + 0.5) / knot.sides);
            mesh.vertices.push_back(frame.point + knot.tube_radius * (angle.cos * frame.normal +
                                                                      angle.sin * frame.binormal));
        }
    }
    const auto rings = static_cast<std::uint32_t>(knot.rings),
               sides = static_cast<std::uint32_t>(knot.sides);
    for (std::uint32_t i = 0; i < rings; ++i) {
        const std::uint32_t here = i * sides, next = (i + 1) % rings * sides;
        for (std::uint32_t j = 0; j < sides; ++j) {
            const std::uint32_t k = (j + 1) % sides;
            mesh.triangles.push_back({here + j, here + k, next + j});
            mesh.triangles.push_back({here + k, next + k, next + j});
        }
    }
    return mesh;
}

}  // namespace scb::scenes
