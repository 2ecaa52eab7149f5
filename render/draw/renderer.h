#pragma once

#include <memory>
#include <optional>

#include "render/files/image.h"
#include "render/gl/context.h"
#include "render/view/picture.h"
#include "scb/mesh.h"

namespace scb::render {

class Overlay;

/// A drawn picture, and, on request, the id that owns each pixel.
struct Rendering {
    Image image;
    std::optional<IdImage> ids;
};

/// Draws pictures into framebuffers of its own, in one context that must outlive it and be current
/// in every call. The same picture gives the same bytes, regardless of earlier pictures.
class Renderer {
  public:
    /// Throws DrawError if the OpenGL library refuses the shaders.
    explicit Renderer(const Context& context);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Takes a mesh to the GPU, once, for any number of pictures. The mesh itself is not needed
    /// afterwards; its indices must be in range. Throws InputError if OpenGL cannot number the
    /// corners of so many triangles (more than 715 827 882).
    MeshHandle upload(const Mesh& mesh);
    void release(MeshHandle handle);

    /// The largest side, in pixels, of a picture with this number of samples (1 or 4). The memory
    /// of the machine may allow less.
    int largest_size(int samples) const;

    /// Draws the picture and, on top of it, the overlay (which has no ids). Throws InputError if
    /// the size is empty or larger than the OpenGL library can draw, if samples is neither 1 nor 4,
    /// or if a pane is not inside the picture. Throws DrawError if the OpenGL library fails,
    /// usually for lack of memory.
    Rendering draw(const Picture& picture, const Overlay* overlay = nullptr, bool with_ids = false);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace scb::render
