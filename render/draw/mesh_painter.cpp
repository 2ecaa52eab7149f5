#include "render/draw/mesh_painter.h"

#include <Eigen/Geometry>

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "render/gl/embedded.h"
#include "scb/error.h"

SCB_DECLARE_EMBEDDED(eye_glsl)
SCB_DECLARE_EMBEDDED(light_glsl)
SCB_DECLARE_EMBEDDED(mesh_vert)
SCB_DECLARE_EMBEDDED(mesh_frag)

namespace scb::render {

namespace {

/// More than any surface is drawn nearer than it is, so that surfaces that coincide do not hide
/// each other.
constexpr float nearer_than_coinciding = 2e-4f;

struct Corner {
    std::array<float, 3> position;
    std::array<std::int16_t, 4> normal;
};

/// The unit normal in 16 bits; +z for a degenerate triangle, which covers no pixel.
std::array<std::int16_t, 4> quantised_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 cross = (b - a).cross(c - a);
    const double length = std::sqrt(squared_norm(cross));
    if (!(length > 0)) return {0, 0, 32767, 0};
    std::array<std::int16_t, 4> result{};
    for (int i = 0; i < 3; ++i)
        result[static_cast<std::size_t>(i)] =
            static_cast<std::int16_t>(std::lround(cross[i] / length * 32767));
    return result;
}

}  // namespace

int corner_count(std::size_t triangle_count) {
    constexpr std::size_t limit = std::numeric_limits<int>::max() / 3;
    if (triangle_count > limit)
        throw InputError("A mesh of " + std::to_string(triangle_count) +
                         " triangles is too large to draw; the limit is " + std::to_string(limit) +
                         ".");
    return static_cast<int>(3 * triangle_count);
}

MeshPainter::MeshPainter(const Gl& gl)
    : gl_(gl),
      chosen_corners_(gl),
      program_(gl, {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(mesh_vert)},
               {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(light_glsl), SCB_EMBEDDED(mesh_frag)}) {}

MeshHandle MeshPainter::upload(const Mesh& mesh) {
    const int count = corner_count(mesh.triangles.size());
    const Box box = bounding_box(mesh);
    GpuMesh gpu{(box.lower + box.upper) / 2,
                (box.upper - box.lower).maxCoeff() / 2,
                count,
                GlBuffer(gl_),
                GlBuffer(gl_),
                GlVertexArray(gl_)};
    if (!(gpu.scale > 0)) gpu.scale = 1;

    std::vector<Corner> corners;
    corners.reserve(static_cast<std::size_t>(count));
    for (const Triangle& triangle : mesh.triangles) {
        std::array<Vec3, 3> local;
        for (std::size_t i = 0; i < 3; ++i)
            local[i] = (mesh.vertices[triangle[i]] - gpu.origin) / gpu.scale;
        const auto normal = quantised_normal(local[0], local[1], local[2]);
        for (const Vec3& p : local)
            corners.push_back(
                {{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])},
                 normal});
    }
    gl_.BindVertexArray(gpu.attributes.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, gpu.corners.name());
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(Corner)),
                   corners.data(), GL_STATIC_DRAW);
    gl_.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner),
                            buffer_offset(offsetof(Corner, position)));
    gl_.VertexAttribPointer(1, 3, GL_SHORT, GL_TRUE, sizeof(Corner),
                            buffer_offset(offsetof(Corner, normal)));
    gl_.EnableVertexAttribArray(0);
    gl_.EnableVertexAttribArray(1);

    const MeshHandle handle{next_index_++};
    meshes_.emplace(handle.index, std::move(gpu));
    return handle;
}

void MeshPainter::release(MeshHandle handle) { meshes_.erase(handle.index); }

const MeshPainter::GpuMesh& MeshPainter::prepare(const MeshDraw& draw, const EyeView& view,
                                                 Rgba8 background) {
    const auto found = meshes_.find(draw.mesh.index);
    assert(found != meshes_.end() && "the mesh was uploaded to this renderer and not released");
    const GpuMesh& gpu = found->second;
    const auto f = [](double value) { return static_cast<float>(value); };
    const auto channel = [](std::uint8_t value) { return static_cast<float>(value) / 255; };

    const Vec3 origin = to_eye_units(view, transform_point(draw.pose, gpu.origin));
    std::array<float, 16> to_eye{};
    std::array<float, 9> normal_to_eye{};
    for (int column = 0; column < 3; ++column) {
        const Vec3 axis = rotate_to_eye(view, draw.pose.rotation.col(column));
        for (int row = 0; row < 3; ++row) {
            to_eye[static_cast<std::size_t>(4 * column + row)] =
                f(axis[row] * (gpu.scale / view.unit));
            normal_to_eye[static_cast<std::size_t>(3 * column + row)] = f(axis[row]);
        }
    }
    for (int row = 0; row < 3; ++row) to_eye[static_cast<std::size_t>(12 + row)] = f(origin[row]);
    to_eye[15] = 1;

    program_.use();
    set_eye_uniforms(program_, view);
    program_.set_mat4("to_eye", to_eye.data());
    program_.set_mat3("normal_to_eye", normal_to_eye.data());
    program_.set("color", channel(draw.color.r), channel(draw.color.g), channel(draw.color.b), 1);
    program_.set("fade", channel(background.r), channel(background.g), channel(background.b),
                 f(draw.dim));
    program_.set("shading", f(draw.shading));
    program_.set("edges", draw.edges ? 1 : 0);
    program_.set("hatched", draw.hatched ? 1 : 0);
    program_.set("first_id", draw.first_id);
    program_.set("transparency", 0.0f);
    program_.set("nearer", 0.0f);
    program_.set("colored", draw.triangle_colors.empty() ? 0 : 1);

    gl_.BindVertexArray(gpu.attributes.name());
    if (draw.triangle_colors.empty()) {
        gl_.DisableVertexAttribArray(2);
    } else {
        assert(3 * draw.triangle_colors.size() == static_cast<std::size_t>(gpu.corner_count) &&
               "one color for each triangle");
        std::vector<Rgba8> colors;
        colors.reserve(static_cast<std::size_t>(gpu.corner_count));
        for (const Rgba8 color : draw.triangle_colors) colors.insert(colors.end(), 3, color);
        gl_.BindBuffer(GL_ARRAY_BUFFER, gpu.colors.name());
        gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(colors.size() * sizeof(Rgba8)),
                       colors.data(), GL_STREAM_DRAW);
        gl_.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Rgba8), nullptr);
        gl_.EnableVertexAttribArray(2);
    }
    return gpu;
}

void MeshPainter::draw_triangles(const std::vector<std::uint32_t>& triangles) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t triangle : triangles)
        for (std::uint32_t corner = 0; corner < 3; ++corner)
            corners.push_back(3 * triangle + corner);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, chosen_corners_.name());
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                   static_cast<GLsizeiptr>(corners.size() * sizeof(std::uint32_t)), corners.data(),
                   GL_STREAM_DRAW);
    gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(corners.size()), GL_UNSIGNED_INT,
                               nullptr, 0);
}

void MeshPainter::draw(const MeshDraw& draw, const EyeView& view, Rgba8 background) {
    draw_prepared(draw, prepare(draw, view, background));
}

void MeshPainter::draw_hidden(const MeshDraw& draw, const EyeView& view, Rgba8 background) {
    const GpuMesh& gpu = prepare(draw, view, background);
    program_.set("transparency", static_cast<float>(1 - draw.shine_through));
    program_.set("nearer", nearer_than_coinciding);
    draw_prepared(draw, gpu);
}

void MeshPainter::draw_prepared(const MeshDraw& draw, const GpuMesh& gpu) {
    if (draw.chosen)
        draw_triangles(*draw.chosen);
    else
        gl_.DrawArrays(GL_TRIANGLES, 0, gpu.corner_count);
}

}  // namespace scb::render
