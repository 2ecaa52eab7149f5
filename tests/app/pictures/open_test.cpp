#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace scb::app {
namespace {

/// A desktop, on which `xdg-open` notes what it is to open and then does as `script` says.
struct Open : testing::Test {
    TemporaryFolder folder;
    std::string out = folder / "out", noted = folder / "noted";

    Surroundings desktop(const std::string& script) {
        const std::string bin = folder / "bin";
        std::filesystem::create_directory(bin);
        write_text(bin + "/xdg-open", "#!/bin/sh\necho \"$@\" >'" + noted + "'\n" + script + "\n");
        std::filesystem::permissions(bin + "/xdg-open", std::filesystem::perms::owner_all);
        return {"", {"PATH=" + bin + ":/usr/bin:/bin"}};
    }
    std::string opened_by(const std::string& arguments) {
        std::filesystem::remove(noted);
        const ProgramRun run =
            run_scb("--quiet " + arguments + " --size 320x240 --open -o " + out, desktop("exit 0"));
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(run.err, "") << arguments;
        return std::filesystem::exists(noted) ? file_text(noted) : "";
    }
};

TEST_F(Open, OpensWhatWasMade) {
    EXPECT_EQ(opened_by("render traversal cone --frames 80"),
              out + "/cone_scb_traversal_size-320x240_frame-0080.png\n");
    EXPECT_EQ(opened_by("render traversal cone --frames 70,80"), out + "\n");
    EXPECT_EQ(opened_by("render levels cone --frames 0 --levels 2,3"),
              out + "/cone_levels_sheet_levels-2-3_size-320x240_frame-0000.png\n");
    EXPECT_EQ(opened_by("inspect cone --frames 80 --top 1"),
              out + "/cone_scb_inspect_size-320x240_frames-80_top-1.html\n");
    EXPECT_EQ(opened_by("explain cone --frames 80 --pair 0,0"),
              out + "/cone_scb_explain_size-320x240_frame-0080_A-0_B-0.png\n");
    EXPECT_EQ(opened_by("tune cone --frames 80 --no-time"),
              out + "/cone_tune_frames-80_no-time_size-320x240.png\n");
}

TEST_F(Open, IsASentenceWhereThatFails) {
    const std::string arguments =
        "render traversal cone --frames 80 --size 320x240 --open -o " + out;
    const std::string picture = out + "/cone_scb_traversal_size-320x240_frame-0080.png";
    const ProgramRun failed = run_scb(arguments, desktop("echo 'no desktop' >&2; exit 3"));
    EXPECT_EQ(failed.status, 0);
    EXPECT_EQ(failed.err, "scb: --open: xdg-open could not open " + picture +
                              " (no desktop); open it yourself.\n");
    const ProgramRun none = run_scb(arguments, {"", {"PATH=/nowhere"}});
    EXPECT_EQ(none.status, 0);
    EXPECT_EQ(none.err, "scb: --open: there is neither xdg-open nor open on PATH; open " + picture +
                            " yourself.\n");
    EXPECT_EQ(failed.out, none.out);
    const ProgramRun nothing = run_scb("inspect cone --frames 80 --open");
    EXPECT_EQ(nothing.status, 2);
    EXPECT_EQ(nothing.err,
              "scb: error: --open: there is nothing to open; say where pictures go with -o DIR.\n");
}

}  // namespace
}  // namespace scb::app
