#include "render/draw/eye_view.h"

#include <algorithm>
#include <cassert>

namespace scb::render {

EyeView make_eye_view(const Pane& pane, const PixelRect& part, int scale) {
    const PixelRect& v = pane.viewport;
    assert(v.width > 0 && v.height > 0 && "a pane needs a rectangle");
    EyeView view;
    view.camera = pane.camera;
    view.unit = pane.camera.far_distance;
    view.near_plane = pane.camera.near_distance / view.unit;
    view.half_height = pane.camera.orthographic ? pane.camera.view_height / 2 / view.unit
                                                : tan_half_fov(pane.camera);
    view.half_width = view.half_height * v.width / v.height;
    view.target = {scale * (v.x - part.x), scale * (part.y + part.height - v.y - v.height),
                   scale * v.width, scale * v.height};
    view.scale = scale;
    if (const std::optional<FacePlane>& clip = pane.camera.clip) {
        view.clip_normal = rotate_to_eye(view, -clip->normal);
        const double offset = clip->offset - dot(clip->normal, view.camera.position);
        // Drawn coordinates are about 1, and single precision has a limit.
        constexpr double beyond_all = 1e6;
        view.clip_offset = std::clamp(offset / view.unit, -beyond_all, beyond_all);
    }
    return view;
}

Vec3 to_eye_units(const EyeView& view, const Vec3& point) {
    return to_eye(view.camera, point) / view.unit;
}

double behind_clip(const EyeView& view, const Vec3& point) {
    return dot(view.clip_normal, point) + view.clip_offset;
}

Vec3 rotate_to_eye(const EyeView& view, const Vec3& direction) {
    const Mat3& axes = view.camera.axes;
    return {dot(axes.col(0), direction), dot(axes.col(1), direction), dot(axes.col(2), direction)};
}

void set_eye_uniforms(const GlProgram& program, const EyeView& view) {
    const auto f = [](double value) { return static_cast<float>(value); };
    program.set("orthographic", view.camera.orthographic ? 1 : 0);
    program.set("half_view", f(view.half_width), f(view.half_height));
    program.set("near_plane", f(view.near_plane));
    program.set("target", f(view.target.x), f(view.target.y), f(view.target.width),
                f(view.target.height));
    program.set("pixel", f(2 * view.half_height / view.target.height));
    program.set("line_scale", f(view.scale));
    const Vec3& normal = view.clip_normal;
    program.set("clip", f(normal[0]), f(normal[1]), f(normal[2]), f(view.clip_offset));
}

}  // namespace scb::render
