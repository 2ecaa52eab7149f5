#pragma once

#include <memory>

#include "render/gl/context.h"
#include "render/gl/gl.h"

namespace scb::render {

/// The interface of a back end. Internal to the context.
struct ContextPlatform {
    using Function = void (*)();

    GlBackend backend{};
    Gl gl;
    GlInfo info;
    /// Shaders and buffers of a renderer, for the next one; owned by the code that stored them.
    void* kept_for_renderer = nullptr;
    /// OpenGL has failed here, so nothing is kept.
    bool failed = false;

    virtual ~ContextPlatform() = default;
    /// Makes the context current in the calling thread; throws GlError.
    virtual void make_current() = 0;
    /// The address of the OpenGL function of that name, or null.
    virtual Function address(const char* name) = 0;
};

/// Both throw GlError, also if the back end is not compiled in.
std::unique_ptr<ContextPlatform> make_osmesa_platform();
std::unique_ptr<ContextPlatform> make_egl_platform();

}  // namespace scb::render
