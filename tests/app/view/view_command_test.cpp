#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/temporary_folder.h"

namespace scb::app {
namespace {

/// What the page's manifest says.
nlohmann::json manifest_of(const std::string& page) {
    const std::string before = "id=\"manifest\">";
    const std::size_t at = page.find(before) + before.size();
    return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
}

TEST(ViewCommand, MakesOnePageTheSameEachTime) {
    const TemporaryFolder folder;
    const std::string file = folder / "a.html";
    ASSERT_EQ(run_scb("view cone --volume scb,rss --level 3 --mesh -o " + file).status, 0);
    const std::string page = file_text(file);
    const nlohmann::json manifest = manifest_of(page);
    EXPECT_EQ(manifest["kinds"].size(), 2u);
    EXPECT_EQ(manifest["bodies"].size(), 2u);
    EXPECT_EQ(manifest["frames"].size(), 200u);
    EXPECT_EQ(manifest["meshes"].size(), 1u) << "both bodies have one mesh";
    EXPECT_EQ(manifest["start"]["level"], 3);
    EXPECT_EQ(manifest["start"]["mesh"], true);
    ASSERT_EQ(run_scb("view cone --volume scb,rss --level 3 --mesh -o " + file).status, 0);
    EXPECT_TRUE(file_text(file) == page);
}

TEST(ViewCommand, TakesRecordings) {
    const TemporaryFolder folder;
    const std::string recording = folder / "own.scbrec", file = folder / "a.html";
    ASSERT_EQ(run_scb("trace cone --frames 60,100 --volume obb -o " + recording).status, 0);
    ASSERT_EQ(run_scb("view " + recording + " --frames 100 -o " + file).status, 0);
    EXPECT_EQ(run_scb("view " + recording + " --queries all -o " + file).status, 2);
    const nlohmann::json manifest = manifest_of(file_text(file));
    EXPECT_EQ(manifest["frames"], nlohmann::json({100}));
    EXPECT_EQ(manifest["trees"].size(), 2u);
}

TEST(ViewCommand, RefusesWhatMakesNoSense) {
    const TemporaryFolder folder;
    for (const char* wrong :
         {"cone -o a.png", "cone --color-by surface", "cone --level 99", "cone --level 1,2",
          "cone --camera contact", "cone --opacity 2", "nothing", "cone --levels 3"}) {
        const ProgramRun run =
            run_scb(std::string("view ") + wrong, "cd " + folder.path.string() + " &&");
        EXPECT_EQ(run.status, 2) << wrong;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
    }
    EXPECT_EQ(files_in(folder.path), 0u);
    EXPECT_EQ(run_scb("view cone -o " + folder / "no/such/a.html").status, 3);
}

}  // namespace
}  // namespace scb::app
