#pragma once

#include <functional>
#include <span>

#include "core/volumes/any_volume.h"
#include "render/view/camera.h"
#include "scb/mesh.h"
#include "scb/pose.h"

namespace scb::render {

/// The support function of a set of points in the world: the largest `direction.x` over the set,
/// for a unit direction. Minus infinity for the empty set.
using Support = std::function<double(const Vec3& direction)>;

/// The support of volumes in the world frame. The volumes must outlive the result.
Support support_of(std::span<const AnyVolume> volumes);

/// The support of the vertices that the mesh's triangles use, placed by `pose`. The mesh must
/// outlive the result.
Support support_of(const Mesh& mesh, const Pose& pose);

/// The middle of the box of the set along the world's axes.
Vec3 center_of(const Support& support);

/// The support of everything in `parts` together.
Support support_of_all(std::vector<Support> parts);

/// `part` of the way from the support `inner`, which must be seen, to the support `outer`, which
/// contains it.
Support support_between(Support inner, Support outer, double part);

/// Width / height of the set as a camera with these axes sees it from afar; 1 if it has no height.
double aspect_of(const Support& support, const Mat3& axes);

struct CameraFit {
    double aspect = 16.0 / 9;  ///< width / height of the view
    double margin =
        0.04;  ///< free space at every side, as a part of the view's width and height; below 0.5
    bool orthographic = false;
    double vertical_fov = 30;  ///< degrees
};

/// The closest camera with these axes for which everything in the support stays inside the view
/// minus its margins. Exact: the set touches at least two opposite sides (left and right, or top
/// and bottom), because each volume's own support along the normals of the view's four side planes
/// places the camera. The depth range is set too. A set without size (one point) is viewed from a
/// distance at which one unit fills the view. Throws InputError if the set is empty or not finite.
Camera fit_camera(const Mat3& axes, const Support& support, const CameraFit& options = {});

/// The spread of the volumes' centers in the view, the larger of width and height, as a part of the
/// view's height. 0 if there are none.
double extent_in_view(const Camera& camera, std::span<const AnyVolume> volumes);

/// A ball that contains the centers of volumes, about the middle of them all.
Ball ball_about_centers(std::span<const AnyVolume> volumes);

/// Makes the camera's depth range as narrow as the support allows. Points behind the eye, or nearer
/// than a ten thousandth of the far distance, are cut off.
void set_depth_range(Camera& camera, const Support& support);

}  // namespace scb::render
