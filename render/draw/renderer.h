#pragma once

#include <memory>
#include <optional>

#include "render/files/image.h"
#include "render/gl/context.h"
#include "render/view/picture.h"
#include "scb/mesh.h"

namespace scb::render {

class Overlay;

/// A drawn picture, and which thing owns each pixel of it where that was asked for.
struct Rendering {
    Image image;
    std::optional<IdImage> ids;
};

/// Draws pictures into framebuffers of its own, in one context that must outlive it and be current
/// in every call. The same picture gives the same bytes, whatever was drawn before.
class Renderer {
  public:
    /// Throws DrawError where the OpenGL library refuses the shaders.
    explicit Renderer(const Context& context);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Takes a mesh to the GPU, once, for any number of pictures. The mesh itself is not needed any
    /// more; its indices must be in range. Throws InputError where it has more triangles than
    /// OpenGL can number the corners of (715 827 882).
    MeshHandle upload(const Mesh& mesh);
    void release(MeshHandle handle);

    /// The most pixels that a side of a picture with that many samples (1 or 4) may have here. The
    /// memory of the machine may allow less.
    int largest_size(int samples) const;

    /// Draws the picture and, on top of it, the overlay (which has no ids). Throws InputError where
    /// the size is empty or larger than the OpenGL library can draw, where samples is neither 1 nor
    /// 4, or where a pane does not lie inside the picture; DrawError where the OpenGL library
    /// fails, for want of memory as a rule.
    Rendering draw(const Picture& picture, const Overlay* overlay = nullptr, bool with_ids = false);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace scb::render
