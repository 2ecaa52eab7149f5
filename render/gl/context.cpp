#include "render/gl/context.h"

#include <sys/mman.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

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
    // "llvmpipe (LLVM 15.0.6, 256 bits)": the vector width depends on the machine.
    info.renderer = renderer.substr(0, renderer.find(" ("));
    return info;
}

/// Platforms that no context uses now. This object is never destroyed: the OpenGL library may end
/// before static objects do.
struct KeptPlatforms {
    std::mutex mutex;
    std::vector<std::unique_ptr<ContextPlatform>> idle;
};

KeptPlatforms& kept_platforms() {
    static auto* const kept = new KeptPlatforms;
    return *kept;
}

/// Null if none is kept.
std::unique_ptr<ContextPlatform> take_platform(GlBackend backend) {
    KeptPlatforms& kept = kept_platforms();
    const std::lock_guard lock(kept.mutex);
    const auto found = std::find_if(kept.idle.begin(), kept.idle.end(),
                                    [&](const auto& idle) { return idle->backend == backend; });
    if (found == kept.idle.end()) return nullptr;
    std::unique_ptr<ContextPlatform> platform = std::move(*found);
    kept.idle.erase(found);
    return platform;
}

std::unique_ptr<ContextPlatform> make_platform(GlBackend backend) {
    pin_environment(backend);
    // Memory that Mesa, its compiler and its threads need (measured with 22.3.6).
    constexpr std::uint64_t mebi = std::uint64_t{1} << 20;
    require_address_space(400 * mebi +
                          72 * mebi * std::max(1u, std::thread::hardware_concurrency()));
    std::unique_ptr<ContextPlatform> platform =
        backend == GlBackend::osmesa ? make_osmesa_platform() : make_egl_platform();
    platform->make_current();
#define SCB_GL_LOAD(TYPE, NAME)                                                       \
    platform->gl.NAME =                                                               \
        reinterpret_cast<decltype(platform->gl.NAME)>(platform->address("gl" #NAME)); \
    if (!platform->gl.NAME)                                                           \
        throw GlError("The OpenGL library has no function gl" #NAME "; OpenGL 3.3 is needed.");
    SCB_GL_FUNCTIONS(SCB_GL_LOAD)
#undef SCB_GL_LOAD
    platform->backend = backend;
    platform->info = describe(platform->gl, backend);
    return platform;
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

Context::Context(GlBackend backend) : platform_(take_platform(backend)) {
    if (platform_)
        platform_->make_current();
    else
        platform_ = make_platform(backend);
    gl_ = platform_->gl;
    info_ = platform_->info;
}

Context::~Context() {
    if (platform_->failed) return;
    KeptPlatforms& kept = kept_platforms();
    const std::lock_guard lock(kept.mutex);
    kept.idle.push_back(std::move(platform_));
}

void Context::make_current() const { platform_->make_current(); }

void require_address_space(std::uint64_t bytes) {
    rlimit limits{};
    if (::getrlimit(RLIMIT_AS, &limits) != 0 || limits.rlim_cur == RLIM_INFINITY) return;
    void* const room =
        ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED)
        throw DrawError("Drawing takes " + std::to_string(bytes >> 20) +
                        " MiB of memory more, which the limit of " +
                        std::to_string(limits.rlim_cur >> 20) +
                        " MiB has no room for; raise it (ulimit -v), or choose a smaller --size.");
    ::munmap(room, bytes);
}

}  // namespace scb::render
