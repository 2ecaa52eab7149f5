#pragma once

#include <cstdint>
#include <vector>

#include "core/volumes/convex_shape.h"
#include "render/draw/eye_view.h"
#include "render/gl/gl_object.h"
#include "render/gl/gl_program.h"

namespace scb::render {

/// The surfaces of convex volumes. For rounded volumes, as shaders/convex.vert reads them: a grid
/// of directions that all share, and for each volume its farthest point along each direction, in
/// eye space. For others the planes of a polytope, as shaders/polytope.frag reads them.
class ConvexPoints {
  public:
    explicit ConvexPoints(const Gl& gl);

    /// Forgets the points. The grid is finer for fewer volumes.
    void start(std::size_t volumes);
    void add(const ConvexShape& shape, const EyeView& view);
    /// Returns the number of planes.
    std::size_t add_planes(const ConvexShape& shape, const EyeView& view);
    std::size_t planes() const { return planes_.size() / 4; }

    std::size_t vertices_per_volume() const { return 3 * grid_->triangles.size(); }
    static std::size_t most_points_per_volume();

    /// Makes the program draw the volumes of a batch, from the first one on.
    void use(const GlProgram& program, std::size_t first, std::size_t count);
    void use_planes(const GlProgram& program, std::size_t first, std::size_t count);

  private:
    void upload(const GlBuffer& buffer, const GlTexture& texture, GLenum unit, GLenum format,
                const void* data, std::size_t bytes) const;

    const Gl& gl_;
    const DirectionGrid* grid_ = nullptr;
    GlBuffer corner_buffer_, direction_buffer_, point_buffer_, plane_buffer_;
    GlTexture corners_, directions_, points_texture_, planes_texture_;
    std::vector<float> points_, planes_;
};

}  // namespace scb::render
