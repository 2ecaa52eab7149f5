#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/draw/convex_points.h"
#include "render/draw/eye_view.h"
#include "render/gl/gl_program.h"
#include "render/view/picture.h"

namespace scb::render {

/// A volume as shaders/volume.vert reads it: five texels of four words. 0: its rectangle on the
/// screen (left, bottom, right, top in normalised device coordinates); 1 to 3: its shape in eye
/// space; 4: color, id (its highest bit: hatched), and further numbers of the shape. For rounded
/// volumes, 1 to 3 are the axes of the frame; for polytopes, 1 is the center; see ConvexPoints.
struct PackedVolume {
    enum class Shape { scb, scb2, obb, polytope, convex } shape;
    std::array<std::uint32_t, 20> words;
};

/// Nothing if the volume is outside the view, or has no size.
std::optional<PackedVolume> pack(const VolumeInstance& instance, const EyeView& view);

/// Draws volumes by exact ray casting, each inside its rectangle on the screen: two triangles for
/// any volume, and no special case for an eye inside it. A hierarchy's finer levels have thousands
/// of volumes of a few pixels each. Rounded convex volumes are drawn as meshes of their farthest
/// points.
class VolumePainter {
  public:
    explicit VolumePainter(const Gl& gl);

    /// Draws the volumes with alpha 255, by depth.
    void draw_opaque(const std::vector<VolumeInstance>& volumes, const EyeView& view);

    /// Draws the volumes with alpha below 255: colors from far to near, then depth and ids of the
    /// nearest surfaces.
    void draw_translucent(const std::vector<VolumeInstance>& volumes, const EyeView& view);

  private:
    enum class Sides { nearest = 1, back_then_front = 2 };

    /// Consecutive volumes of one shape in texels_.
    struct Run {
        PackedVolume::Shape shape;
        std::size_t first;
        std::size_t count;
        std::size_t first_of_convex;  // first of its points or planes among all of convex volumes
        std::size_t planes = 0;
    };

    void pack_all(const std::vector<const VolumeInstance*>& volumes, const EyeView& view);
    /// Draws the volumes packed last, in their order.
    void draw(const EyeView& view, Sides sides);
    void upload(std::size_t batch);
    const GlProgram& program_of(PackedVolume::Shape shape) const;

    const Gl& gl_;
    GlProgram scb_program_;
    GlProgram scb2_program_;
    GlProgram obb_program_;
    GlProgram polytope_program_, convex_program_;
    GlVertexArray no_attributes_;
    GlBuffer buffer_;
    GlTexture texture_;
    std::size_t batch_limit_;  // volumes that the buffer may hold at a time; no run crosses a batch
    std::optional<std::size_t> uploaded_batch_;
    std::vector<std::uint32_t> texels_;  // this and the next one are kept to reuse their memory
    std::vector<Run> runs_;
    ConvexPoints convex_;
};

}  // namespace scb::render
