#include "app/scene_camera.h"

namespace scb {

CameraSpec camera_spec_for(const CameraOptions& options, const Scene& scene) {
    CameraSpec spec = options.camera.empty() ? scene.camera.value_or(CameraSpec{}) : parse_camera(options.camera);
    if (!spec.inset && scene.camera) spec.inset = scene.camera->inset;
    if (options.orthographic) spec.orthographic = true;
    return spec;
}

Camera camera_for(const CameraSpec& spec, const Support& support, double aspect) {
    CameraFit fit;
    fit.aspect = aspect;
    fit.orthographic = spec.orthographic.value_or(false);
    fit.vertical_fov = spec.field_of_view;
    Camera camera = fit_camera(orbit_axes(spec.azimuth, spec.elevation), support, fit);
    if (spec.view_height) camera.view_height = *spec.view_height;
    if (!spec.target && !spec.distance) return camera;
    const Vec3 back = camera.axes.col(2);
    const Vec3 target = spec.target.value_or(center_of(support));
    const double distance = spec.distance.value_or(dot(back, Vec3(camera.position - target)));
    camera.position = target + distance * back;
    set_depth_range(camera, support);
    return camera;
}

Camera detail_camera(const CameraSpec& spec, const Inset& inset, const Support& support, double aspect) {
    CameraSpec detail = spec;
    detail.orthographic = true;
    detail.target = inset.center;
    detail.distance.reset();
    detail.view_height = 2 * inset.radius;
    return camera_for(detail, support, aspect);
}

CameraSpec exact_spec(const CameraSpec& spec, const Camera& camera, const Vec3& center) {
    CameraSpec exact = spec;
    exact.orthographic = camera.orthographic;
    exact.distance = dot(Vec3(camera.axes.col(2)), Vec3(camera.position - center));
    exact.target = camera.position - *exact.distance * camera.axes.col(2);
    if (camera.orthographic) exact.view_height = camera.view_height;
    return exact;
}

}  // namespace scb
