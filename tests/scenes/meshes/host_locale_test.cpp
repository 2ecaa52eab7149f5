#include "tests/host_locale.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/text_format.h"
#include "core/platform/tokens.h"
#include "scenes/meshes/mesh_file.h"

namespace scb::scenes {
namespace {

TEST(HostLocale, ChangesNoNumberThatIsWrittenOrRead) {
    const HostLocale german;
    EXPECT_EQ(sentence("vertex ", 12345, " is ", 0.5), "vertex 12345 is 0.5");
    if (!german.is_set) GTEST_SKIP() << "localedef made no locale";
    char text[16];
    std::snprintf(text, sizeof text, "%.1f", 0.5);
    ASSERT_STREQ(text, "0,5");
    EXPECT_EQ(format("%.1f %g", 0.5, 1.5e9), "0.5 1.5e+09");
    EXPECT_EQ(number_in("1.5e400"), std::numeric_limits<double>::infinity());
    EXPECT_EQ(number_in("-1.5e400"), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(number_in("1.5e-400"), 0.0);
    std::snprintf(text, sizeof text, "%.1f", 0.5);
    EXPECT_STREQ(text, "0,5") << "the host keeps its locale";
}

TEST(HostLocale, ChangesNoMesh) {
    const HostLocale german;
    if (!german.is_set) GTEST_SKIP() << "localedef made no locale";
    const TemporaryFolder folder;
    const std::string file = folder.write("tiny.ply",
                                          "ply\nformat ascii 1.0\nelement vertex 3\n"
                                          "property double x\nproperty double y\n"
                                          "property double z\nelement face 1\n"
                                          "property list uchar int vertex_indices\nend_header\n"
                                          "1.5e-400 0.5 0\n1.5 0 0\n0 1.25e-1 0\n3 0 1 2\n");
    const Mesh mesh = load_mesh(file);
    EXPECT_EQ(mesh.vertices[0], (Vec3{0, 0.5, 0}));
    EXPECT_EQ(mesh.vertices[2], (Vec3{0, 0.125, 0}));
}

}  // namespace
}  // namespace scb::scenes
