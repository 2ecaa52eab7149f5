#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace scb::app {
namespace {

TEST(Values, OfOutputsArePictureFilesOrFolders) {
    const TemporaryFolder folder;
    for (const char* command : {"render levels cone", "render pairs cone", "render rejections cone",
                                "render traversal cone", "bench cone", "tune cone", "inspect cone",
                                "explain cone --pair 0,0", "view cone"})
        for (const char* name : {"a.jpg", "a.PNG"}) {
            const ProgramRun run = run_scb(std::string(command) + " -o " + (folder / name));
            EXPECT_EQ(run.status, 2) << command;
            EXPECT_NE(run.err.find(std::string(command) == "view cone"
                                       ? "give a name that ends in .html."
                                       : "pictures are PNG files; name a f"),
                      std::string::npos)
                << run.err;
            EXPECT_EQ(files_in(folder.path), 0u) << command;
        }
}

}  // namespace
}  // namespace scb::app
