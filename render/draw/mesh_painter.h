#pragma once

#include <cstddef>
#include <map>

#include "render/draw/eye_view.h"
#include "render/view/picture.h"
#include "scb/mesh.h"

namespace scb::render {

/// The corners of that many triangles, as OpenGL counts them. Throws InputError where an int does
/// not hold them.
int corner_count(std::size_t triangle_count);

/// Keeps meshes on the GPU and draws them.
class MeshPainter {
  public:
    explicit MeshPainter(const Gl& gl);

    /// Throws InputError where corner_count does.
    MeshHandle upload(const Mesh& mesh);
    void release(MeshHandle handle);
    void forget() { meshes_.clear(); }

    /// `background` is what a dimmed mesh fades into. Asserts that the handle is one of its own.
    void draw(const MeshDraw& mesh, const EyeView& view, Rgba8 background);

  private:
    /// Corner by corner, in units of `scale` about `origin`, so that single precision serves meshes
    /// of any size and any distance from their frame's origin.
    struct GpuMesh {
        Vec3 origin;
        double scale;
        int corner_count;
        GlBuffer corners;
        GlBuffer colors;
        GlVertexArray attributes;
    };

    /// Sets what the program needs for the mesh, its colors among it.
    const GpuMesh& prepare(const MeshDraw& mesh, const EyeView& view, Rgba8 background);

    /// Of the mesh that was prepared.
    void draw_triangles(const std::vector<std::uint32_t>& triangles);

    const Gl& gl_;
    GlBuffer chosen_corners_;
    GlProgram program_;
    std::map<std::uint32_t, GpuMesh> meshes_;
    std::uint32_t next_index_ = 1;
};

}  // namespace scb::render
