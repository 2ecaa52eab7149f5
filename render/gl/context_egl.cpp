#include "render/gl/context.h"
#include "render/gl/context_platform.h"

#ifdef SCB_HAVE_EGL

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace scb::render {

namespace {

struct EglPlatform final : ContextPlatform {
    // Shared by every context of the process, so it is left initialised.
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    EglPlatform() {
        display =
            eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
            throw GlError(
                "EGL has no surfaceless platform; Mesa's EGL (package libegl-mesa0) is needed.");
        bind_desktop_gl();
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
        context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        if (context == EGL_NO_CONTEXT)
            throw GlError(
                "EGL gives no OpenGL 3.3 core context; Mesa's llvmpipe (package libgl1-mesa-dri) "
                "is needed.");
    }
    ~EglPlatform() override {
        if (eglGetCurrentContext() == context)
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }

    static void bind_desktop_gl() {
        if (!eglBindAPI(EGL_OPENGL_API)) throw GlError("EGL does not offer desktop OpenGL.");
    }
    void make_current() override {
        bind_desktop_gl();  // this setting is per thread
        if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
            throw GlError("EGL cannot make its OpenGL context current without a surface.");
    }
    Function address(const char* name) override { return eglGetProcAddress(name); }
};

}  // namespace

std::unique_ptr<ContextPlatform> make_egl_platform() { return std::make_unique<EglPlatform>(); }

}  // namespace scb::render

#else

namespace scb::render {

std::unique_ptr<ContextPlatform> make_egl_platform() {
    throw GlError("This program was built without EGL; choose the other back end, osmesa.");
}

}  // namespace scb::render

#endif
