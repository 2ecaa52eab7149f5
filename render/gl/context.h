#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "render/gl/gl.h"

namespace scb::render {

struct ContextPlatform;

/// The source of the OpenGL context: Mesa's OSMesa library (removed from Mesa 25.1 on), or EGL
/// without a surface (EGL_MESA_platform_surfaceless). Neither needs a display or a GPU.
enum class GlBackend { osmesa, egl };

/// "osmesa" or "egl".
std::string_view to_string(GlBackend backend);

/// The back end of that name, or nothing.
std::optional<GlBackend> gl_backend_from_string(std::string_view name);

/// Whether this program was built with the back end.
bool is_compiled_in(GlBackend backend);

/// The environment has no usable OpenGL: `what()` is one sentence that says what is missing. The
/// program then exits with status 77.
struct GlError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The OpenGL library exists, but could not draw: out of memory, a refused shader, an internal
/// error. `what()` is one sentence. The program then exits with status 3.
struct DrawError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The software that draws the pictures. No member depends on the CPU.
struct GlInfo {
    std::string backend;   ///< "osmesa" or "egl"
    std::string version;   ///< of OpenGL, such as "4.5"
    std::string mesa;      ///< such as "22.3.6"; empty if it is not Mesa
    std::string llvm;      ///< such as "15.0.6"; empty if the renderer has none
    std::string renderer;  ///< such as "llvmpipe"
};

/// An OpenGL 3.3 core context (or later) that can draw into framebuffer objects only. It is current
/// in the thread that made it; several may exist, each used by one thread at a time. The process
/// keeps its platform for the next context, with the shaders of its renderer, since making these
/// takes longer than drawing a picture.
///
/// Before the first context, the environment gets
/// - `GALLIUM_DRIVER=llvmpipe`, regardless of its value: the other software renderers draw other
///   pixels, and OSMesa crashes on an unknown name;
/// - `GALLIUM_OVERRIDE_CPU_CAPS=sse4.1` on x86 (if unset), so that pixels do not depend on whether
///   the CPU has fused multiply-add;
/// - for EGL `LIBGL_ALWAYS_SOFTWARE=1` and `EGL_LOG_LEVEL=fatal` (each if unset): exceptions report
///   errors, not warnings on the standard error stream.
class Context {
  public:
    /// Throws GlError if the back end is not compiled in, or gives no such context.
    explicit Context(GlBackend backend);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Makes this the context of the calling thread; needed only if a program has several.
    void make_current() const;

    const Gl& gl() const { return gl_; }
    /// Its platform, at a constant address.
    ContextPlatform& platform() const { return *platform_; }
    const GlInfo& info() const { return info_; }

  private:
    std::unique_ptr<ContextPlatform> platform_;
    Gl gl_;
    GlInfo info_;
};

/// Throws DrawError if the address space of this process is limited (ulimit -v) and has less room
/// left. OpenGL libraries crash if memory runs out, so call this before they allocate.
void require_address_space(std::uint64_t bytes);

}  // namespace scb::render
