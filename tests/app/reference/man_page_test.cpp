#include <gtest/gtest.h>

#include "core/platform/child_process.h"
#include "tests/app/program.h"

namespace scb::app {
namespace {

std::string page(const TemporaryFolder& folder, const std::string& name) {
    return file_text(folder.path / (name + ".1"));
}

TEST(ManPage, ThereIsOneOfEveryCommand) {
    const TemporaryFolder folder;
    ASSERT_EQ(run_scb("man -o " + folder.path.string()).status, 0);
    for (const char* name : {"scb", "scb-render", "scb-render-levels", "scb-collide",
                             "scb-golden-check", "scb-completion"}) {
        EXPECT_NE(page(folder, name).find(".SH SYNOPSIS\n"), std::string::npos) << name;
    }
    EXPECT_FALSE(std::filesystem::exists(folder.path / "scb-man.1"));
    const std::string levels = page(folder, "scb-render-levels");
    EXPECT_NE(levels.find("\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIDIR\\fR\n"), std::string::npos);
    EXPECT_NE(levels.find("\n.SH EXAMPLES\n"), std::string::npos);
    // What help hides is for nobody.
    EXPECT_EQ(levels.find("mutation"), std::string::npos);
}

TEST(ManPage, TheSameProgramWritesTheSameBytes) {
    const TemporaryFolder a, b;
    ASSERT_EQ(run_scb("man -o " + a.path.string()).status, 0);
    ASSERT_EQ(
        run_scb("man -o " + b.path.string(), {"", {"TZ=Asia/Tokyo", "LC_ALL=C", "COLUMNS=40"}})
            .status,
        0);
    for (const auto& entry : std::filesystem::directory_iterator(a.path))
        EXPECT_EQ(file_text(entry.path()), file_text(b.path / entry.path().filename()));
}

/// The complaints of a program about all pages.
std::string complaints(const std::string& program) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_scb("man -o " + folder.path.string()).status, 0);
    const std::string said = folder / "said";
    const int status = std::system(
        ("cd " + folder.path.string() + " && for page in *.1; do " + program + "; done >said 2>&1")
            .c_str());
    return status == 0 ? file_text(said) : file_text(said) + "status " + std::to_string(status);
}

TEST(ManPage, RoffHasNoComplaint) {
    if (!is_on_path("groff"))
        GTEST_SKIP() << "groff is not installed; install groff-base to check the manual pages.";
    EXPECT_EQ(complaints("groff -ww -man -Tutf8 -z $page"), "");
    EXPECT_EQ(complaints("groff -ww -man -Tutf8 -rLL=60n -z $page"), "");
}

TEST(ManPage, MandocHasNoComplaint) {
    if (!is_on_path("mandoc"))
        GTEST_SKIP() << "mandoc is not installed; install it to check the manual pages.";
    // Pages have no date, so that they are the same whenever they are made.
    EXPECT_EQ(complaints("mandoc -T lint -W warning $page | grep -v 'missing date' || true"), "");
}

}  // namespace
}  // namespace scb::app
