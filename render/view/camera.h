#pragma once

#include <optional>

#include "scb/convex.h"
#include "scb/pose.h"
#include "scb/vec.h"

namespace scb::render {

/// A camera in the world. Eye space is right-handed: x to the right, y up, z backward (towards the
/// viewer).
struct Camera {
    Vec3 position = Vec3::Zero();  ///< of the eye; for an orthographic camera, of the plane where
                                   ///< depth starts
    Mat3 axes =
        Mat3::Identity();  ///< right, up, backward in the columns: a rotation from eye to world
    bool orthographic = false;
    double vertical_fov = 30;  ///< full vertical angle of a perspective camera, degrees, below 180
    double view_height = 2;    ///< height of an orthographic camera's view, world units
    double near_distance =
        0.1;  ///< depth range that is drawn, along -backward, world units, above 0
    double far_distance = 100;
    /// Only points p of the world with normal.p <= offset are drawn; a unit normal. Volumes show
    /// their cross section there; rounded volumes and meshes show their inner side.
    std::optional<FacePlane> clip;
};

/// The axes of a camera that looks at a target from the direction `(cos el sin az, -cos el cos az,
/// sin el)`, Z being up: azimuth 0, elevation 0 looks along +y with x to the right. Angles in
/// degrees; at elevation +-90 the azimuth determines where up points.
Mat3 orbit_axes(double azimuth_degrees, double elevation_degrees);

/// The same if another world direction than z is up: all axes are turned by the smallest rotation
/// that takes z to it.
Mat3 orbit_axes(double azimuth_degrees, double elevation_degrees, const Vec3& up);

/// A camera with orbit_axes, `distance` away from `target` (world units, above 0). The depth range
/// is `distance` / 100 to `distance` * 100. The orthographic view height is the span of the field
/// of view at the target. The caller may set better values (see set_depth_range in fit_camera.h).
Camera orbit_camera(double azimuth_degrees, double elevation_degrees, const Vec3& target,
                    double distance, bool orthographic = false, double vertical_fov = 30);

/// tan(vertical_fov / 2), the same on every machine.
double tan_half_fov(const Camera& camera);

/// A world point in eye space.
Vec3 to_eye(const Camera& camera, const Vec3& point);

/// Where a world point lies in a view of `width` x `height` pixels: x from the left, y from the top
/// (both in pixels, pixel centers at .5), z the distance along the view axis (world units). x and y
/// have no meaning if the point is at or behind the eye of a perspective camera (z <= 0).
Vec3 project(const Camera& camera, const Vec3& point, int width, int height);

/// The pixels that one world unit spans at the depth of `point`, parallel to the view plane, in a
/// view `height` pixels high.
double pixels_per_unit(const Camera& camera, const Vec3& point, int height);

}  // namespace scb::render
