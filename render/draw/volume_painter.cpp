#include "render/draw/volume_painter.h"

#include <algorithm>
#include <tuple>

#include "render/gl/embedded.h"

SCB_DECLARE_EMBEDDED(eye_glsl)
SCB_DECLARE_EMBEDDED(light_glsl)
SCB_DECLARE_EMBEDDED(volume_glsl)
SCB_DECLARE_EMBEDDED(volume_vert)
SCB_DECLARE_EMBEDDED(scb_frag)
SCB_DECLARE_EMBEDDED(scb2_frag)
SCB_DECLARE_EMBEDDED(obb_frag)
SCB_DECLARE_EMBEDDED(convex_vert)
SCB_DECLARE_EMBEDDED(convex_frag)
SCB_DECLARE_EMBEDDED(planes_glsl)
SCB_DECLARE_EMBEDDED(polytope_frag)

namespace scb::render {

namespace {

constexpr std::size_t texels_per_volume = 5;
constexpr std::size_t words_per_volume = 4 * texels_per_volume;

// Corners of triangles that llvmpipe sets up before it must draw them. It keeps some 600 bytes of
// each: 30 MB.
constexpr std::size_t corners_at_once = 6 << 13;

PackedVolume::Shape shape_of(const AnyVolume& volume) {
    if (std::holds_alternative<Scb2>(volume)) return PackedVolume::Shape::scb2;
    if (std::holds_alternative<Obb>(volume)) return PackedVolume::Shape::obb;
    if (const ConvexShape* shape = std::get_if<ConvexShape>(&volume))
        return shape->rounding > 0 ? PackedVolume::Shape::convex : PackedVolume::Shape::polytope;
    return PackedVolume::Shape::scb;
}

std::size_t largest_batch(const Gl& gl) {
    GLint texels = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    // Vertex numbers, up to 288 for a volume of many, must fit into an int.
    return std::min<std::size_t>(
        static_cast<std::size_t>(texels) / ConvexPoints::most_points_per_volume(), 1u << 22);
}

}  // namespace

VolumePainter::VolumePainter(const Gl& gl)
    : gl_(gl),
      scb_program_(gl, {SCB_EMBEDDED(volume_vert)},
                   {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(light_glsl), SCB_EMBEDDED(volume_glsl),
                    SCB_EMBEDDED(scb_frag)}),
      scb2_program_(gl, {SCB_EMBEDDED(volume_vert)},
                    {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(light_glsl), SCB_EMBEDDED(volume_glsl),
                     SCB_EMBEDDED(scb2_frag)}),
      obb_program_(gl, {SCB_EMBEDDED(volume_vert)},
                   {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(light_glsl), SCB_EMBEDDED(volume_glsl),
                    SCB_EMBEDDED(obb_frag)}),
      polytope_program_(
          gl, {SCB_EMBEDDED(volume_vert)},
          {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(light_glsl), SCB_EMBEDDED(volume_glsl),
           SCB_EMBEDDED(planes_glsl), SCB_EMBEDDED(polytope_frag)}),
      convex_program_(gl, {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(convex_vert)},
                      {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(light_glsl), SCB_EMBEDDED(volume_glsl),
                       SCB_EMBEDDED(convex_frag)}),
      no_attributes_(gl),
      buffer_(gl),
      texture_(gl),
      batch_limit_(largest_batch(gl)),
      convex_(gl) {}

void VolumePainter::draw_opaque(const std::vector<VolumeInstance>& volumes, const EyeView& view) {
    std::vector<const VolumeInstance*> drawn;
    for (const VolumeInstance& volume : volumes)
        if (volume.color.a == 255) drawn.push_back(&volume);
    // Batches by program; because of the depth test, the order does not matter.
    std::stable_sort(drawn.begin(), drawn.end(),
                     [](const VolumeInstance* a, const VolumeInstance* b) {
                         return shape_of(a->volume) < shape_of(b->volume);
                     });
    pack_all(drawn, view);
    draw(view, Sides::nearest);
}

void VolumePainter::draw_translucent(const std::vector<VolumeInstance>& volumes,
                                     const EyeView& view) {
    struct Entry {
        double backward;  // coordinate of the center; the farthest center has the lowest
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
    pack_all(sorted, view);

    gl_.DepthMask(GL_FALSE);
    gl_.ColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw(view, Sides::back_then_front);
    gl_.Disable(GL_BLEND);
    gl_.DepthMask(GL_TRUE);
    gl_.ColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

    gl_.ColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw(view, Sides::nearest);
    gl_.ColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void VolumePainter::pack_all(const std::vector<const VolumeInstance*>& volumes,
                             const EyeView& view) {
    texels_.clear();
    runs_.clear();
    uploaded_batch_.reset();
    convex_.start(volumes.size());
    std::size_t count = 0, convex = 0;
    for (const VolumeInstance* volume : volumes) {
        const std::optional<PackedVolume> packed = pack(*volume, view);
        if (!packed) continue;
        const PackedVolume::Shape shape = packed->shape;
        if (runs_.empty() || runs_.back().shape != shape || count % batch_limit_ == 0)
            runs_.push_back({shape, count, 0,
                             shape == PackedVolume::Shape::polytope ? convex_.planes() : convex});
        texels_.insert(texels_.end(), packed->words.begin(), packed->words.end());
        if (shape == PackedVolume::Shape::convex) {
            convex_.add(std::get<ConvexShape>(volume->volume), view);
            ++convex;
            // The index of its points in the run.
            texels_[texels_.size() - 2] = static_cast<std::uint32_t>(runs_.back().count);
        }
        if (shape == PackedVolume::Shape::polytope) {
            const ConvexShape& polytope = std::get<ConvexShape>(volume->volume);
            Run& run = runs_.back();
            const std::size_t planes = convex_.add_planes(polytope, view);
            texels_[texels_.size() - 2] = static_cast<std::uint32_t>(run.planes);
            // Edges of real faces are drawn, but not of faces that approximate a curve.
            constexpr std::uint32_t without_edges = 0x80000000;
            texels_[texels_.size() - 1] =
                static_cast<std::uint32_t>(planes) | (polytope.faces.empty() ? without_edges : 0);
            run.planes += planes;
        }
        ++runs_.back().count;
        ++count;
    }
}

void VolumePainter::draw(const EyeView& view, Sides sides) {
    gl_.BindVertexArray(no_attributes_.name());
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_BUFFER, texture_.name());
    for (const Run& run : runs_) {
        upload(run.first / batch_limit_);
        const GlProgram& program = program_of(run.shape);
        program.use();
        set_eye_uniforms(program, view);
        program.set("volumes", 0);
        program.set("sides", static_cast<int>(sides));
        std::size_t corners = 6 * static_cast<std::size_t>(sides);
        if (run.shape == PackedVolume::Shape::convex) {
            convex_.use(program, run.first_of_convex, run.count);
            corners = convex_.vertices_per_volume() * static_cast<std::size_t>(sides);
        }
        if (run.shape == PackedVolume::Shape::polytope)
            convex_.use_planes(program, run.first_of_convex, run.planes);
        const std::size_t at_once = std::max<std::size_t>(1, corners_at_once / corners);
        for (std::size_t drawn = 0; drawn < run.count; drawn += at_once) {
            // llvmpipe keeps what is set up and not yet drawn, without a limit.
            if (drawn > 0) gl_.Finish();
            const std::size_t count = std::min(at_once, run.count - drawn);
            gl_.DrawArrays(GL_TRIANGLES,
                           static_cast<GLint>(corners * (run.first % batch_limit_ + drawn)),
                           static_cast<GLsizei>(corners * count));
        }
    }
}

const GlProgram& VolumePainter::program_of(PackedVolume::Shape shape) const {
    switch (shape) {
        case PackedVolume::Shape::scb2:
            return scb2_program_;
        case PackedVolume::Shape::obb:
            return obb_program_;
        case PackedVolume::Shape::polytope:
            return polytope_program_;
        case PackedVolume::Shape::convex:
            return convex_program_;
        case PackedVolume::Shape::scb:
            break;
    }
    return scb_program_;
}

void VolumePainter::upload(std::size_t batch) {
    if (uploaded_batch_ == batch) return;
    const std::size_t first = batch * batch_limit_ * words_per_volume;
    const std::size_t count = std::min(texels_.size() - first, batch_limit_ * words_per_volume);
    gl_.BindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
    gl_.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(count * sizeof(std::uint32_t)),
                   texels_.data() + first, GL_STREAM_DRAW);
    gl_.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, buffer_.name());
    uploaded_batch_ = batch;
}

}  // namespace scb::render
