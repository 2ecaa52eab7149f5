#pragma once

#include <cstddef>
#include <map>

#include "render/draw/eye_view.h"
#include "render/view/picture.h"
#include "scb/mesh.h"

namespace scb::render {

/// The number of corners of the triangles, as OpenGL counts them. Throws InputError if it does not
/// fit into an int.
int corner_count(std::size_t triangle_count);

/// Keeps meshes on the GPU and draws them.
class MeshPainter {
  public:
    explicit MeshPainter(const Gl& gl);

    /// Throws InputError as corner_count does.
    MeshHandle upload(const Mesh& mesh);
    void release(MeshHandle handle);
    void forget() { meshes_.clear(); }

    /// `background` is the color into which a dimmed mesh fades. Asserts that the handle is from
    /// this painter.
    void draw(const MeshDraw& mesh, const EyeView& view, Rgba8 background);

    /// Draws a mesh that shines through, with its own opacity. The caller has blending on, compares
    /// depths the other way round, and does not write them, so that only hidden parts are drawn.
    void draw_hidden(const MeshDraw& mesh, const EyeView& view, Rgba8 background);

  private:
    /// Coordinates of corners, in units of `scale` about `origin`, so that single precision serves
    /// meshes of any size and any distance from their frame's origin.
    struct GpuMesh {
        Vec3 origin;
        double scale;
        int corner_count;
        GlBuffer corners;
        GlBuffer colors;
        GlVertexArray attributes;
    };

    /// Sets the program's data for the mesh, including its colors.
    const GpuMesh& prepare(const MeshDraw& mesh, const EyeView& view, Rgba8 background);

    void draw_prepared(const MeshDraw& mesh, const GpuMesh& gpu);
    /// Draws triangles of the prepared mesh.
    void draw_triangles(const std::vector<std::uint32_t>& triangles);

    const Gl& gl_;
    GlBuffer chosen_corners_;
    GlProgram program_;
    std::map<std::uint32_t, GpuMesh> meshes_;
    std::uint32_t next_index_ = 1;
};

}  // namespace scb::render
