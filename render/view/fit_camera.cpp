#include "render/view/fit_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "scb/error.h"

namespace scb::render {

namespace {

/// The eye's position along one axis of the view, and its depth coordinate.
struct Placement {
    double along;
    double backward;
};

/// The eye (along, backward) at which both side planes with slope `tangent` touch the set. The set
/// is inside the plane towards +axis if `(axis + tangent back).(x - eye) <= 0` for every x.
Placement touch_both_sides(const Support& support, const Vec3& axis, const Vec3& back,
                           double tangent) {
    const double length = std::sqrt(1 + tangent * tangent);
    const double plus = length * support((axis + tangent * back) / length);
    const double minus = length * support((tangent * back - axis) / length);
    return {(plus - minus) / 2, (plus + minus) / (2 * tangent)};
}

double width_along(const Support& support, const Vec3& axis) {
    return support(axis) + support(-axis);
}

double middle_along(const Support& support, const Vec3& axis) {
    return (support(axis) - support(-axis)) / 2;
}

}  // namespace

Support support_of(std::span<const AnyVolume> volumes) {
    return [volumes](const Vec3& direction) {
        double most = -std::numeric_limits<double>::infinity();
        for (const AnyVolume& volume : volumes) most = std::max(most, reach(volume, direction));
        return most;
    };
}

Support support_of(const Mesh& mesh, const Pose& pose) {
    return [&mesh, pose](const Vec3& direction) {
        const Vec3 local = rotate(pose.rotation.transpose(), direction);
        double most = -std::numeric_limits<double>::infinity();
        for (const Triangle& triangle : mesh.triangles)
            for (const std::uint32_t corner : triangle)
                most = std::max(most, dot(mesh.vertices[corner], local));
        return most + dot(pose.translation, direction);
    };
}

Support support_of_all(std::vector<Support> parts) {
    return [parts = std::move(parts)](const Vec3& direction) {
        double most = -std::numeric_limits<double>::infinity();
        for (const Support& part : parts) most = std::max(most, part(direction));
        return most;
    };
}

Vec3 center_of(const Support& support) {
    return {middle_along(support, Vec3::UnitX()), middle_along(support, Vec3::UnitY()),
            middle_along(support, Vec3::UnitZ())};
}

Support support_between(Support inner, Support outer, double part) {
    return [inner = std::move(inner), outer = std::move(outer), part](const Vec3& direction) {
        const double within = inner(direction);
        return within + part * std::max(0.0, outer(direction) - within);
    };
}

double aspect_of(const Support& support, const Mat3& axes) {
    const double height = width_along(support, axes.col(1));
    return height > 0 ? width_along(support, axes.col(0)) / height : 1;
}

Camera fit_camera(const Mat3& axes, const Support& support, const CameraFit& options) {
    Camera camera;
    camera.axes = axes;
    camera.orthographic = options.orthographic;
    camera.vertical_fov = options.vertical_fov;
    const Vec3 right = axes.col(0), up = axes.col(1), back = axes.col(2);
    const double size = std::max(
        {width_along(support, right), width_along(support, up), width_along(support, back)});
    if (!std::isfinite(size))
        throw InputError(
            "There is nothing with a finite size to fit the camera to; place it with --camera "
            "orbit.");

    const double part = 1 - 2 * options.margin;
    const double tangent = tan_half_fov(camera);
    double along_right = middle_along(support, right);
    double along_up = middle_along(support, up);
    double along_back = 0;
    if (size <= 0) {
        const double unit = std::max(1.0, std::abs(support(back)) * 1e-3);
        camera.view_height = unit;
        along_back = support(back) + unit / (2 * tangent);
    } else if (options.orthographic) {
        camera.view_height =
            std::max(width_along(support, up), width_along(support, right) / options.aspect) / part;
        // A set seen edge-on has no height to fit.
        camera.view_height = std::max(camera.view_height, size * 1e-6);
        along_back = support(back) + size;
    } else {
        const Placement x = touch_both_sides(support, right, back, tangent * options.aspect * part);
        const Placement y = touch_both_sides(support, up, back, tangent * part);
        along_right = x.along;
        along_up = y.along;
        // A segment along the view axis would put the eye on its end.
        along_back = std::max({x.backward, y.backward, support(back) + size * 1e-3});
        camera.view_height = 2 * tangent * (along_back - middle_along(support, back));
    }
    camera.position = along_right * right + along_up * up + along_back * back;
    set_depth_range(camera, support);
    return camera;
}

double extent_in_view(const Camera& camera, std::span<const AnyVolume> volumes) {
    if (volumes.empty()) return 0;
    Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
    for (const AnyVolume& volume : volumes) {
        const Vec3 at = project(camera, center(volume), 1, 1);
        lower = lower.cwiseMin(at);
        upper = upper.cwiseMax(at);
    }
    return std::max(upper[0] - lower[0], upper[1] - lower[1]);
}

Ball ball_about_centers(std::span<const AnyVolume> volumes) {
    Ball ball{center_of(support_of(volumes)), 0};
    for (const AnyVolume& volume : volumes)
        ball.radius = std::max(ball.radius, std::sqrt(squared_norm(center(volume) - ball.center)));
    return ball;
}

void set_depth_range(Camera& camera, const Support& support) {
    const Vec3 back = camera.axes.col(2);
    const double eye = dot(camera.position, back);
    const double nearest = eye - support(back);
    const double farthest = eye + support(-back);
    // Everything is behind the eye, or there is nothing: any range will do.
    const double beyond = farthest > 0 && std::isfinite(farthest) ? farthest : camera.view_height;
    camera.far_distance = beyond * 1.01;
    camera.near_distance = std::max(nearest * 0.98, camera.far_distance * 1e-4);
}

}  // namespace scb::render
