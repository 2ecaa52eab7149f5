#include "render/view/camera.h"

#include <cmath>

#include "core/base/portable_math.h"

namespace scb::render {

Mat3 orbit_axes(double azimuth_degrees, double elevation_degrees) {
    const SinCos az = sin_cos_degrees(azimuth_degrees);
    const SinCos el = sin_cos_degrees(elevation_degrees);
    Mat3 axes;
    axes.col(0) = Vec3(az.cos, az.sin, 0);
    axes.col(1) = Vec3(-el.sin * az.sin, el.sin * az.cos, el.cos);
    axes.col(2) = Vec3(el.cos * az.sin, -el.cos * az.cos, el.sin);
    return axes;
}

Mat3 orbit_axes(double azimuth_degrees, double elevation_degrees, const Vec3& up) {
    const Vec3 to = up / std::sqrt(squared_norm(up)), from = Vec3::UnitZ();
    const Mat3 axes = orbit_axes(azimuth_degrees, elevation_degrees);
    Mat3 turned;
    for (int i = 0; i < 3; ++i) {
        const Vec3 v = axes.col(i);
        // If `up` is down, there is no smallest rotation; any half turn will do, here about x.
        if (to[2] < -1 + 1e-12) {
            turned.col(i) = Vec3(v[0], -v[1], -v[2]);
            continue;
        }
        const Vec3 w = cross(from, to);
        turned.col(i) = v + cross(w, v) + cross(w, cross(w, v)) / (1 + to[2]);
    }
    return turned;
}

Camera orbit_camera(double azimuth_degrees, double elevation_degrees, const Vec3& target,
                    double distance, bool orthographic, double vertical_fov) {
    Camera camera;
    camera.axes = orbit_axes(azimuth_degrees, elevation_degrees);
    camera.position = target + distance * camera.axes.col(2);
    camera.orthographic = orthographic;
    camera.vertical_fov = vertical_fov;
    camera.view_height = 2 * distance * tan_half_fov(camera);
    camera.near_distance = distance / 100;
    camera.far_distance = distance * 100;
    return camera;
}

double tan_half_fov(const Camera& camera) {
    const SinCos half = sin_cos_degrees(camera.vertical_fov / 2);
    return half.sin / half.cos;
}

Vec3 to_eye(const Camera& camera, const Vec3& point) {
    const Vec3 offset = point - camera.position;
    return {dot(camera.axes.col(0), offset), dot(camera.axes.col(1), offset),
            dot(camera.axes.col(2), offset)};
}

Vec3 project(const Camera& camera, const Vec3& point, int width, int height) {
    const Vec3 eye = to_eye(camera, point);
    const double scale = pixels_per_unit(camera, point, height);
    return {width / 2.0 + scale * eye[0], height / 2.0 - scale * eye[1], -eye[2]};
}

double pixels_per_unit(const Camera& camera, const Vec3& point, int height) {
    const double view_height = camera.orthographic
                                   ? camera.view_height
                                   : -2 * to_eye(camera, point)[2] * tan_half_fov(camera);
    return height / view_height;
}

}  // namespace scb::render
