#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace scb::app {
namespace {

TEST(Values, SuggestTheNearestWord) {
    for (const auto& [words, sentence] : std::vector<std::pair<std::string, std::string>>{
             {"collide cone --test corected", "test, did you mean corrected?; give one of"},
             {"collide cone --layout quantised8", "layout, did you mean quantized8?; give some"},
             {"collide cone --split csot", "--split csot: unknown, did you mean cost?; give"},
             {"bench cone --split paper,csot",
              "divide nodes, did you mean cost?; give paper, cost"},
             {"collide cone --descent voluem", "unknown, did you mean volume?; give"},
             {"scenes spheres-l0", "a built-in scene, did you mean spheres-l1?; `scb scenes`"}}) {
        const ProgramRun run = run_scb(words);
        EXPECT_EQ(run.status, 2) << words;
        EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
    }
}

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
