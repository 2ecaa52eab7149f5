#include "render/gl/gl_program.h"

#include <array>
#include <string>
#include <vector>

#include "render/gl/context.h"

namespace scb::render {

namespace {

void attach_shader(const Gl& gl, GLuint program, GLenum stage,
                   std::initializer_list<std::string_view> sources) {
    std::string text = "#version 330 core\n";
    for (const std::string_view source : sources) text += source;
    const char* pointer = text.c_str();

    const GLuint shader = gl.CreateShader(stage);
    gl.ShaderSource(shader, 1, &pointer, nullptr);
    gl.CompileShader(shader);
    GLint compiled = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::array<char, 1024> log{};
    if (!compiled)
        gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader);  // the program keeps it
    if (!compiled)
        throw DrawError("The OpenGL library refuses a shader: " + std::string(log.data()));
}

}  // namespace

GlProgram::GlProgram(const Gl& gl, std::initializer_list<std::string_view> vertex_sources,
                     std::initializer_list<std::string_view> fragment_sources)
    : gl_(&gl), object_(gl) {
    attach_shader(gl, object_.name(), GL_VERTEX_SHADER, vertex_sources);
    attach_shader(gl, object_.name(), GL_FRAGMENT_SHADER, fragment_sources);
    gl.LinkProgram(object_.name());
    GLint linked = 0;
    gl.GetProgramiv(object_.name(), GL_LINK_STATUS, &linked);
    if (linked) return;
    std::array<char, 1024> log{};
    gl.GetProgramInfoLog(object_.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw DrawError("The OpenGL library cannot link a shader program: " + std::string(log.data()));
}

}  // namespace scb::render
