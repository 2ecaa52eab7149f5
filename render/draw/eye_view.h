#pragma once

#include "render/gl/gl_program.h"
#include "render/view/camera.h"
#include "render/view/picture.h"

namespace scb::render {

/// A pane's camera as the shaders need it. Lengths are divided by the far distance, so that single
/// precision serves scenes of any size. These functions compute in double precision.
struct EyeView {
    Camera camera;
    double unit = 1;        ///< world length of one unit of eye space: the far distance
    double near_plane = 0;  ///< in eye units; the far plane is at 1
    double half_width =
        0;  ///< of the view: at depth 1 (perspective) or anywhere (orthographic), eye units
    double half_height = 0;
    PixelRect target;  ///< of the pane in the render target, origin at the bottom left
    int scale = 1;     ///< render target pixels per pixel of the picture, in x and y
    /// Points p of eye space with clip_normal.p + clip_offset >= 0 are drawn. Both are 0 without a
    /// clipping plane. A unit normal; eye units.
    Vec3 clip_normal = Vec3::Zero();
    double clip_offset = 0;
};

/// `part`: the rectangle of the picture that the render target has. `scale` is 1 or 2. Asserts that
/// the pane's rectangle is not empty.
EyeView make_eye_view(const Pane& pane, const PixelRect& part, int scale);

/// A world point in eye space, in eye units.
Vec3 to_eye_units(const EyeView& view, const Vec3& point);

/// How far a point of eye space is behind the clipping plane, in eye units; drawn points have 0 or
/// more.
double behind_clip(const EyeView& view, const Vec3& point);

/// A world direction in eye space.
Vec3 rotate_to_eye(const EyeView& view, const Vec3& direction);

/// Sets the uniforms of shaders/eye.glsl in a program that is in use.
void set_eye_uniforms(const GlProgram& program, const EyeView& view);

}  // namespace scb::render
