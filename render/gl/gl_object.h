#pragma once

#include <utility>

#include "render/gl/gl.h"

namespace scb::render {

/// Owns one OpenGL object and deletes it; the context must be current then. `Traits` makes and
/// deletes objects.
template <typename Traits>
class GlObject {
  public:
    GlObject() = default;
    explicit GlObject(const Gl& gl) : gl_(&gl), name_(Traits::create(gl)) {}
    GlObject(GlObject&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlObject() {
        if (name_) Traits::destroy(*gl_, name_);
    }

    GLuint name() const { return name_; }

  private:
    const Gl* gl_ = nullptr;
    GLuint name_ = 0;
};

#define SCB_GL_OBJECT(TYPE, PLURAL)                                                     \
    struct TYPE##Traits {                                                               \
        static GLuint create(const Gl& gl) {                                            \
            GLuint name = 0;                                                            \
            gl.Gen##PLURAL(1, &name);                                                   \
            return name;                                                                \
        }                                                                               \
        static void destroy(const Gl& gl, GLuint name) { gl.Delete##PLURAL(1, &name); } \
    };                                                                                  \
    using Gl##TYPE = GlObject<TYPE##Traits>;

SCB_GL_OBJECT(Buffer, Buffers)
SCB_GL_OBJECT(Texture, Textures)
SCB_GL_OBJECT(Framebuffer, Framebuffers)
SCB_GL_OBJECT(VertexArray, VertexArrays)
#undef SCB_GL_OBJECT

/// The offset of an attribute in a buffer, as OpenGL expects it.
inline const void* buffer_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace scb::render
