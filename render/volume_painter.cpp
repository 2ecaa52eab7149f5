#include "render/volume_painter.h"

#include <algorithm>
#include <tuple>

#include "render/embedded.h"
#include "render/packed_volume.h"

SCB_DECLARE_EMBEDDED(eye_glsl)
SCB_DECLARE_EMBEDDED(light_glsl)
SCB_DECLARE_EMBEDDED(volume_glsl)
SCB_DECLARE_EMBEDDED(volume_vert)
SCB_DECLARE_EMBEDDED(scb_frag)
SCB_DECLARE_EMBEDDED(obb_frag)

namespace scb {

namespace {

constexpr std::size_t texels_per_volume = 5;

std::size_t largest_batch(const Gl& gl) {
    GLint texels = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    // And the vertex numbers, 12 for a volume, must fit into an int.
    return std::min<std::size_t>(static_cast<std::size_t>(texels) / texels_per_volume, 1u << 24);
}

}  // namespace

VolumePainter::VolumePainter(const Gl& gl)
    : gl_(gl),
      scb_program_(gl, {SCB_EMBEDDED(volume_vert)},
                   {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(light_glsl), SCB_EMBEDDED(volume_glsl),
                    SCB_EMBEDDED(scb_frag)}),
      obb_program_(gl, {SCB_EMBEDDED(volume_vert)},
                   {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(light_glsl), SCB_EMBEDDED(volume_glsl),
                    SCB_EMBEDDED(obb_frag)}),
      no_attributes_(gl),
      buffer_(gl),
      texture_(gl),
      batch_limit_(largest_batch(gl)) {}

void VolumePainter::draw_opaque(const std::vector<VolumeInstance>& volumes, const EyeView& view) {
    std::vector<const VolumeInstance*> opaque;
    for (const VolumeInstance& volume : volumes)
        if (volume.color.a == 255) opaque.push_back(&volume);
    // Batches by program; the depth test makes the order of no account.
    std::stable_partition(opaque.begin(), opaque.end(), [](const VolumeInstance* volume) {
        return !std::holds_alternative<Obb>(volume->volume);
    });
    draw(opaque, view, Sides::nearest);
}

void VolumePainter::draw_translucent(const std::vector<VolumeInstance>& volumes,
                                     const EyeView& view) {
    struct Entry {
        double backward;  // coordinate of the center: the farthest is the lowest
        const VolumeInstance* volume;
    };
    std::vector<Entry> entries;
    for (const VolumeInstance& volume : volumes)
        if (volume.color.a > 0 && volume.color.a < 255)
            entries.push_back({to_eye_units(view, center(volume.volume))[2], &volume});
    if (entries.empty()) return;
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.backward, a.volume->id) < std::tie(b.backward, b.volume->id);
    });
    std::vector<const VolumeInstance*> sorted;
    for (const Entry& entry : entries) sorted.push_back(entry.volume);

    gl_.DepthMask(GL_FALSE);
    gl_.ColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw(sorted, view, Sides::back_then_front);
    gl_.Disable(GL_BLEND);
    gl_.DepthMask(GL_TRUE);
    gl_.ColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

    gl_.ColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw(sorted, view, Sides::nearest);
    gl_.ColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void VolumePainter::draw(const std::vector<const VolumeInstance*>& volumes, const EyeView& view,
                         Sides sides) {
    texels_.clear();
    Shape shape = Shape::scb;
    std::size_t count = 0;
    const auto flush = [&] {
        draw_batch(shape, count, view, sides);
        texels_.clear();
        count = 0;
    };
    for (const VolumeInstance* volume : volumes) {
        const std::optional<PackedVolume> packed = pack(*volume, view);
        if (!packed) continue;
        const Shape its_shape = packed->is_box ? Shape::obb : Shape::scb;
        if (its_shape != shape || count == batch_limit_) flush();
        shape = its_shape;
        texels_.insert(texels_.end(), packed->words.begin(), packed->words.end());
        ++count;
    }
    flush();
}

void VolumePainter::draw_batch(Shape shape, std::size_t count, const EyeView& view, Sides sides) {
    if (count == 0) return;
    gl_.BindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
    gl_.BufferData(GL_TEXTURE_BUFFER,
                   static_cast<GLsizeiptr>(texels_.size() * sizeof(std::uint32_t)), texels_.data(),
                   GL_STREAM_DRAW);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_BUFFER, texture_.name());
    gl_.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, buffer_.name());

    const GlProgram& program = shape == Shape::scb ? scb_program_ : obb_program_;
    program.use();
    set_eye_uniforms(program, view);
    program.set("volumes", 0);
    program.set("sides", static_cast<int>(sides));
    gl_.BindVertexArray(no_attributes_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0,
                   static_cast<GLsizei>(6 * static_cast<std::size_t>(sides) * count));
}

}  // namespace scb
