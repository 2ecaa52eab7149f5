#include "render/gl/context.h"
#include "render/gl/context_platform.h"

#ifdef SCB_HAVE_OSMESA

#include <GL/osmesa.h>

#include <array>
#include <cstdint>

namespace scb::render {

namespace {

struct OsmesaPlatform final : ContextPlatform {
    OSMesaContext context = nullptr;
    // OSMesa needs a default framebuffer to become current; nothing is ever drawn into it.
    std::array<std::uint32_t, 16 * 16> unused_buffer{};

    OsmesaPlatform() {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  0,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
        context = OSMesaCreateContextAttribs(attributes, nullptr);
        if (!context)
            throw GlError("OSMesa gives no OpenGL 3.3 core context; Mesa's llvmpipe is needed.");
    }
    ~OsmesaPlatform() override { OSMesaDestroyContext(context); }

    void make_current() override {
        if (!OSMesaMakeCurrent(context, unused_buffer.data(), GL_UNSIGNED_BYTE, 16, 16))
            throw GlError("OSMesa cannot make its OpenGL context current.");
    }
    Function address(const char* name) override { return OSMesaGetProcAddress(name); }
};

}  // namespace

std::unique_ptr<ContextPlatform> make_osmesa_platform() {
    return std::make_unique<OsmesaPlatform>();
}

}  // namespace scb::render

#else

namespace scb::render {

std::unique_ptr<ContextPlatform> make_osmesa_platform() {
    throw GlError("This program was built without OSMesa; choose the other back end, egl.");
}

}  // namespace scb::render

#endif
