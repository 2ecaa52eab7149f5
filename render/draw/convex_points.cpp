#include "render/draw/convex_points.h"

#include <algorithm>
#include <cmath>

namespace scb::render {
namespace {

/// Few volumes are large in the picture, thousands are small.
constexpr int steps_of_few = 12, steps_of_some = 6, steps_of_many = 2;

const DirectionGrid& grid_for(std::size_t volumes) {
    static const DirectionGrid fine = direction_grid(steps_of_few),
                               middle = direction_grid(steps_of_some),
                               coarse = direction_grid(steps_of_many);
    return volumes <= 100 ? fine : volumes <= 4000 ? middle : coarse;
}

void append(std::vector<float>& to, const Vec3& v) {
    for (int i = 0; i < 3; ++i) to.push_back(static_cast<float>(v[i]));
    to.push_back(0);
}

}  // namespace

ConvexPoints::ConvexPoints(const Gl& gl)
    : gl_(gl),
      corner_buffer_(gl),
      direction_buffer_(gl),
      point_buffer_(gl),
      plane_buffer_(gl),
      corners_(gl),
      directions_(gl),
      points_texture_(gl),
      planes_texture_(gl) {}

std::size_t ConvexPoints::most_points_per_volume() { return 6 * steps_of_few * steps_of_few + 2; }

void ConvexPoints::start(std::size_t volumes) {
    grid_ = &grid_for(volumes);
    points_.clear();
    planes_.clear();
}

void ConvexPoints::add(const ConvexShape& shape, const EyeView& view) {
    for (const Vec3& own : grid_->directions) {
        const Vec3 d = rotate(shape.axes, own);
        const Vec3 point = shape.center + shape.support_point(d) + shape.rounding * d;
        append(points_, to_eye_units(view, point));
    }
}

std::size_t ConvexPoints::add_planes(const ConvexShape& shape, const EyeView& view) {
    const std::vector<FacePlane> planes = planes_about(shape, touching_directions());
    for (const FacePlane& plane : planes) {
        const double length = std::sqrt(squared_norm(plane.normal));
        append(planes_, rotate_to_eye(view, plane.normal / length));
        planes_.back() = static_cast<float>(plane.offset / length / view.unit);
    }
    return planes.size();
}

void ConvexPoints::use_planes(const GlProgram& program, std::size_t first, std::size_t count) {
    upload(plane_buffer_, planes_texture_, 1, GL_RGBA32F, planes_.data() + 4 * first,
           4 * 4 * count);
    gl_.ActiveTexture(GL_TEXTURE0);
    program.set("planes", 1);
}

void ConvexPoints::upload(const GlBuffer& buffer, const GlTexture& texture, GLenum unit,
                          GLenum format, const void* data, std::size_t bytes) const {
    gl_.BindBuffer(GL_TEXTURE_BUFFER, buffer.name());
    gl_.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
    gl_.ActiveTexture(GL_TEXTURE0 + unit);
    gl_.BindTexture(GL_TEXTURE_BUFFER, texture.name());
    gl_.TexBuffer(GL_TEXTURE_BUFFER, format, buffer.name());
}

void ConvexPoints::use(const GlProgram& program, std::size_t first, std::size_t count) {
    std::vector<float> directions;
    for (const Vec3& d : grid_->directions) append(directions, d);
    const std::size_t floats = 4 * grid_->directions.size();
    upload(corner_buffer_, corners_, 1, GL_R32UI, grid_->triangles.data(),
           4 * vertices_per_volume());
    upload(direction_buffer_, directions_, 2, GL_RGBA32F, directions.data(), 4 * directions.size());
    upload(point_buffer_, points_texture_, 3, GL_RGBA32F, points_.data() + floats * first,
           4 * floats * count);
    gl_.ActiveTexture(GL_TEXTURE0);
    program.set("corners", 1);
    program.set("directions", 2);
    program.set("points", 3);
    program.set("corners_per_volume", static_cast<int>(vertices_per_volume()));
    program.set("points_per_volume", static_cast<int>(grid_->directions.size()));
}

}  // namespace scb::render
