#include "render/gl/context.h"

#include <cstdlib>

#include "tests/render/gl/gl_fixture.h"

namespace scb::render {
namespace {

/// Makes a context in a new process, whose environment is as `prepare` leaves it; the exit status
/// says whether llvmpipe draws.
template <typename Prepare>
[[noreturn]] void make_context(GlBackend backend, Prepare prepare) {
    prepare();
    try {
        const Context context(backend);
        std::_Exit(context.info().renderer == "llvmpipe" ? 0 : 1);
    } catch (const GlError&) {
        std::_Exit(2);
    }
}

TEST(ContextDeathTest, DrawsWithLlvmpipeWhateverTheEnvironmentAsksFor) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    for (const char* driver : {"zz", "softpipe"})
        EXPECT_EXIT(make_context(any_backend(), [&] { setenv("GALLIUM_DRIVER", driver, 1); }),
                    testing::ExitedWithCode(0), "^$");
}

TEST(ContextDeathTest, AFailingEglIsSilent) {
    if (!is_compiled_in(GlBackend::egl)) GTEST_SKIP() << "no EGL";
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        make_context(GlBackend::egl, [] { setenv("LIBGL_DRIVERS_PATH", "/nonexistent", 1); }),
        testing::ExitedWithCode(2), "^$");
}

TEST(Context, SaysWhatItIsWithoutMachineFacts) {
    Drawing drawing;
    const GlInfo& info = drawing.context.info();
    EXPECT_FALSE(info.version.empty());
    EXPECT_EQ(info.renderer.find("bits"), std::string::npos);
    EXPECT_EQ(info.version.find(' '), std::string::npos);
}

}  // namespace
}  // namespace scb::render
