#include "render/gl/context.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <thread>

#include "render/gl/address_space.h"
#include "render/gl/context_platform.h"

namespace scb::render {

namespace {

void pin_environment(GlBackend backend) {
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
#if defined(__x86_64__) || defined(__i386__)
    setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 0);
#endif
    if (backend == GlBackend::egl) {
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
        setenv("EGL_LOG_LEVEL", "fatal", 0);
    }
}

std::string gl_text(const Gl& gl, GLenum name) {
    const GLubyte* text = gl.GetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

/// The digits and dots that follow `key` in `text`.
std::string number_after(const std::string& text, const std::string& key) {
    const std::size_t at = text.find(key);
    if (at == std::string::npos) return "";
    const std::size_t begin = at + key.size();
    return text.substr(begin, text.find_first_not_of("0123456789.", begin) - begin);
}

GlInfo describe(const Gl& gl, GlBackend backend) {
    const std::string version = gl_text(gl, GL_VERSION);
    const std::string renderer = gl_text(gl, GL_RENDERER);
    GlInfo info;
    info.backend = to_string(backend);
    info.version = number_after(version, "");
    info.mesa = number_after(version, "Mesa ");
    info.llvm = number_after(renderer, "LLVM ");
    // "llvmpipe (LLVM 15.0.6, 256 bits)": the vector width is the machine's business.
    info.renderer = renderer.substr(0, renderer.find(" ("));
    return info;
}

}  // namespace

std::string_view to_string(GlBackend backend) {
    return backend == GlBackend::osmesa ? "osmesa" : "egl";
}

std::optional<GlBackend> gl_backend_from_string(std::string_view name) {
    if (name == "osmesa") return GlBackend::osmesa;
    if (name == "egl") return GlBackend::egl;
    return std::nullopt;
}

bool is_compiled_in(GlBackend backend) {
#ifdef SCB_HAVE_OSMESA
    if (backend == GlBackend::osmesa) return true;
#endif
#ifdef SCB_HAVE_EGL
    if (backend == GlBackend::egl) return true;
#endif
    static_cast<void>(backend);
    return false;
}

Context::Context(GlBackend backend) {
    pin_environment(backend);
    // What Mesa takes for itself, its compiler and its threads (measured with 22.3.6).
    constexpr std::uint64_t mebi = std::uint64_t{1} << 20;
    require_address_space(400 * mebi +
                          72 * mebi * std::max(1u, std::thread::hardware_concurrency()));
    platform_ = backend == GlBackend::osmesa ? make_osmesa_platform() : make_egl_platform();
    platform_->make_current();
#define SCB_GL_LOAD(TYPE, NAME)                                                      \
    gl_.NAME = reinterpret_cast<decltype(gl_.NAME)>(platform_->address("gl" #NAME)); \
    if (!gl_.NAME)                                                                   \
        throw GlError("The OpenGL library has no function gl" #NAME "; OpenGL 3.3 is needed.");
    SCB_GL_FUNCTIONS(SCB_GL_LOAD)
#undef SCB_GL_LOAD
    info_ = describe(gl_, backend);
}

Context::~Context() = default;

void Context::make_current() const { platform_->make_current(); }

}  // namespace scb::render
