#pragma once

#include <initializer_list>
#include <string_view>

#include "render/gl/gl_object.h"

namespace scb::render {

struct ProgramTraits {
    static GLuint create(const Gl& gl) { return gl.CreateProgram(); }
    static void destroy(const Gl& gl, GLuint name) { gl.DeleteProgram(name); }
};

/// A linked shader program. Uniforms are set by name while it is in use; a name that the program
/// does not have is ignored, as OpenGL does.
class GlProgram {
  public:
    GlProgram() = default;
    /// The sources of a stage are concatenated behind `#version 330 core`. Throws DrawError if the
    /// compiler refuses them.
    GlProgram(const Gl& gl, std::initializer_list<std::string_view> vertex_sources,
              std::initializer_list<std::string_view> fragment_sources);

    void use() const { gl_->UseProgram(object_.name()); }
    void set(const char* name, float value) const { gl_->Uniform1f(at(name), value); }
    void set(const char* name, int value) const { gl_->Uniform1i(at(name), value); }
    void set(const char* name, GLuint value) const { gl_->Uniform1ui(at(name), value); }
    void set(const char* name, float x, float y) const { gl_->Uniform2f(at(name), x, y); }
    void set(const char* name, float x, float y, float z, float w) const {
        gl_->Uniform4f(at(name), x, y, z, w);
    }
    /// Column by column.
    void set_mat3(const char* name, const float* values) const {
        gl_->UniformMatrix3fv(at(name), 1, GL_FALSE, values);
    }
    void set_mat4(const char* name, const float* values) const {
        gl_->UniformMatrix4fv(at(name), 1, GL_FALSE, values);
    }

  private:
    GLint at(const char* name) const { return gl_->GetUniformLocation(object_.name(), name); }

    const Gl* gl_ = nullptr;
    GlObject<ProgramTraits> object_;
};

}  // namespace scb::render
