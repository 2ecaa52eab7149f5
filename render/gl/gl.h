#pragma once

#include <GL/glcorearb.h>

namespace scb::render {

/// The functions of OpenGL 3.3 core that this library calls. A list of its own, since the usual
/// loaders ask GLX or a display for addresses, and there is neither here.
#define SCB_GL_FUNCTIONS(X)                               \
    X(ACTIVETEXTURE, ActiveTexture)                       \
    X(ATTACHSHADER, AttachShader)                         \
    X(BINDBUFFER, BindBuffer)                             \
    X(BINDFRAMEBUFFER, BindFramebuffer)                   \
    X(BINDTEXTURE, BindTexture)                           \
    X(BINDVERTEXARRAY, BindVertexArray)                   \
    X(BLENDFUNCSEPARATE, BlendFuncSeparate)               \
    X(BUFFERDATA, BufferData)                             \
    X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)     \
    X(CLEARBUFFERFV, ClearBufferfv)                       \
    X(CLEARBUFFERUIV, ClearBufferuiv)                     \
    X(COLORMASKI, ColorMaski)                             \
    X(COMPILESHADER, CompileShader)                       \
    X(CREATEPROGRAM, CreateProgram)                       \
    X(CREATESHADER, CreateShader)                         \
    X(DELETEBUFFERS, DeleteBuffers)                       \
    X(DELETEFRAMEBUFFERS, DeleteFramebuffers)             \
    X(DELETEPROGRAM, DeleteProgram)                       \
    X(DELETESHADER, DeleteShader)                         \
    X(DELETETEXTURES, DeleteTextures)                     \
    X(DELETEVERTEXARRAYS, DeleteVertexArrays)             \
    X(DEPTHFUNC, DepthFunc)                               \
    X(DEPTHMASK, DepthMask)                               \
    X(DISABLE, Disable)                                   \
    X(DISABLEVERTEXATTRIBARRAY, DisableVertexAttribArray) \
    X(DRAWARRAYS, DrawArrays)                             \
    X(DRAWARRAYSINSTANCED, DrawArraysInstanced)           \
    X(DRAWBUFFERS, DrawBuffers)                           \
    X(DRAWELEMENTSBASEVERTEX, DrawElementsBaseVertex)     \
    X(ENABLE, Enable)                                     \
    X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray)   \
    X(FINISH, Finish)                                     \
    X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)         \
    X(GENBUFFERS, GenBuffers)                             \
    X(GENFRAMEBUFFERS, GenFramebuffers)                   \
    X(GENTEXTURES, GenTextures)                           \
    X(GENVERTEXARRAYS, GenVertexArrays)                   \
    X(GETERROR, GetError)                                 \
    X(GETINTEGERV, GetIntegerv)                           \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)               \
    X(GETPROGRAMIV, GetProgramiv)                         \
    X(GETSHADERINFOLOG, GetShaderInfoLog)                 \
    X(GETSHADERIV, GetShaderiv)                           \
    X(GETSTRING, GetString)                               \
    X(GETUNIFORMLOCATION, GetUniformLocation)             \
    X(LINKPROGRAM, LinkProgram)                           \
    X(PIXELSTOREI, PixelStorei)                           \
    X(READBUFFER, ReadBuffer)                             \
    X(READPIXELS, ReadPixels)                             \
    X(SCISSOR, Scissor)                                   \
    X(SHADERSOURCE, ShaderSource)                         \
    X(TEXBUFFER, TexBuffer)                               \
    X(TEXIMAGE2D, TexImage2D)                             \
    X(TEXPARAMETERI, TexParameteri)                       \
    X(TEXSUBIMAGE2D, TexSubImage2D)                       \
    X(UNIFORM1F, Uniform1f)                               \
    X(UNIFORM1I, Uniform1i)                               \
    X(UNIFORM1UI, Uniform1ui)                             \
    X(UNIFORM2F, Uniform2f)                               \
    X(UNIFORM3F, Uniform3f)                               \
    X(UNIFORM4F, Uniform4f)                               \
    X(UNIFORMMATRIX3FV, UniformMatrix3fv)                 \
    X(UNIFORMMATRIX4FV, UniformMatrix4fv)                 \
    X(USEPROGRAM, UseProgram)                             \
    X(VERTEXATTRIBDIVISOR, VertexAttribDivisor)           \
    X(VERTEXATTRIBIPOINTER, VertexAttribIPointer)         \
    X(VERTEXATTRIBPOINTER, VertexAttribPointer)           \
    X(VIEWPORT, Viewport)

/// The addresses of those functions in one context, called as `gl.Clear(...)`.
struct Gl {
#define SCB_GL_MEMBER(TYPE, NAME) PFNGL##TYPE##PROC NAME = nullptr;
    SCB_GL_FUNCTIONS(SCB_GL_MEMBER)
#undef SCB_GL_MEMBER
};

}  // namespace scb::render
