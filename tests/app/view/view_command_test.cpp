#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/temporary_folder.h"

namespace scb::app {
namespace {

constexpr const char* tetrahedron =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n";

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
    ASSERT_EQ(manifest["columns"].size(), 2u);
    EXPECT_EQ(manifest["columns"][0]["bodies"].size(), 2u);
    EXPECT_EQ(manifest["same_nodes"], true);
    EXPECT_EQ(manifest["frames"].size(), 200u);
    EXPECT_EQ(manifest["meshes"].size(), 1u) << "both bodies have one mesh";
    EXPECT_EQ(manifest["start"]["level"], 3);
    EXPECT_EQ(manifest["start"]["mesh"], true);
    ASSERT_EQ(run_scb("view cone --volume scb,rss --level 3 --mesh -o " + file).status, 0);
    EXPECT_TRUE(file_text(file) == page);
}

/// Titles of the columns, and how many frames of each have their query.
std::vector<std::pair<std::string, std::size_t>> columns_of(const std::string& file) {
    std::vector<std::pair<std::string, std::size_t>> columns;
    const nlohmann::json manifest = manifest_of(file_text(file));
    for (const nlohmann::json& column : manifest["columns"])
        columns.emplace_back(column["title"],
                             column["query"].is_null() ? 0 : column["query"]["frames"].size());
    return columns;
}

TEST(ViewCommand, ComparesTestsTracesRecordingsAndScenes) {
    using Columns = std::vector<std::pair<std::string, std::size_t>>;
    const TemporaryFolder folder;
    const std::string a = folder / "a.scbrec", b = folder / "b.scbrec",
                      recording = folder / "own.scbrec", file = folder / "a.html";
    ASSERT_EQ(run_scb("trace cone --frames 60,100 --test corrected -o " + a).status, 0);
    ASSERT_EQ(run_scb("trace cone --frames 60,100 --volume obb -o " + b).status, 0);
    ASSERT_EQ(run_scb("trace cone --frames 100 --volume obb --records -o " + recording).status, 0);
    const auto view = [&](const std::string& what) {
        const ProgramRun run = run_scb("view " + what + " --steps 0 -o " + file);
        EXPECT_EQ(run.status, 0) << run.err;
        return columns_of(file);
    };
    EXPECT_EQ(view(a), (Columns{{"SCB", 2}}));
    EXPECT_EQ(view(a + " --queries 100"), (Columns{{"SCB", 1}}));
    EXPECT_EQ(view(a + " " + b), (Columns{{"SCB, test corrected", 2}, {"OBB", 2}}));
    EXPECT_EQ(view("cone --compare corrected,extents"),
              (Columns{{"corrected", 1}, {"extents", 1}}));
    EXPECT_EQ(view(recording + " --compare recorded,scb2")[1].first, "SCB2");
    const Columns scenes = view("cone spheres-l1 --level 3");
    EXPECT_EQ(scenes, (Columns{{"cone, SCB", 1}, {"spheres-l1, SCB", 1}}));
    EXPECT_EQ(manifest_of(file_text(file))["frames"].size(), 200u) << "frames of both scenes";
    EXPECT_EQ(manifest_of(file_text(file))["same_nodes"], false);
    EXPECT_EQ(view("cone --queries none"), (Columns{{"SCB", 0}}));
    for (const char* wrong : {" --queries none", " --compare scb,obb", " --volume obb"})
        EXPECT_EQ(run_scb("view " + a + wrong + " -o " + file).status, 2) << wrong;
}

TEST(ViewCommand, TakesTwoOfSeveralBodies) {
    const TemporaryFolder folder;
    const std::string scene = folder / "three.json", file = folder / "a.html";
    write_text(folder / "m.off", tetrahedron);
    write_text(scene,
               R"({"scb_scene": 1, "name": "three", "models": [{"name": "m", "file": "m.off"}],
        "bodies": [{"name": "p", "model": "m"}, {"name": "q", "model": "m"}, {"name": "r", "model": "m"}]})");
    ASSERT_EQ(run_scb("view " + scene + " -o " + file).status, 0);
    EXPECT_EQ(columns_of(file)[0].second, 0u);
    ASSERT_EQ(run_scb("view " + scene + " --bodies r,p -o " + file).status, 0);
    const nlohmann::json column = manifest_of(file_text(file))["columns"][0];
    EXPECT_EQ(column["bodies"][0]["name"], "r");
    EXPECT_EQ(column["query"]["frames"][0]["pairs"], 16);
    EXPECT_EQ(run_scb("view " + scene + " --queries 0 -o " + file).status, 2);
}

TEST(ViewCommand, TakesRecordings) {
    const TemporaryFolder folder;
    const std::string recording = folder / "own.scbrec", file = folder / "a.html";
    ASSERT_EQ(run_scb("trace cone --frames 60,100 --volume obb --records -o " + recording).status,
              0);
    ASSERT_EQ(run_scb("view " + recording + " --frames 100 -o " + file).status, 0);
    EXPECT_EQ(run_scb("view " + recording + " --queries all -o " + file).status, 2);
    const nlohmann::json manifest = manifest_of(file_text(file));
    EXPECT_EQ(manifest["frames"], nlohmann::json({100}));
    EXPECT_EQ(manifest["trees"].size(), 2u);
}

TEST(ViewCommand, GivesTheVerdictOnTheRecordedFrame) {
    const TemporaryFolder folder;
    const std::string whole = folder / "own.scbrec", file = folder / "a.html";
    ASSERT_EQ(run_scb("trace cone --frames 60,100 --volume obb --records -o " + whole).status, 0);
    const auto verdict = [&](const std::string& recording) {
        EXPECT_EQ(run_scb("view " + recording + " --frames 100 -o " + file).status, 0);
        return manifest_of(file_text(file))["columns"][0]["verdict"][0];
    };
    EXPECT_EQ(verdict(whole), "Frame 100: Valid.");
    // The same without the last pair of the last frame.
    const std::string text = folder / "own.jsonl", broken = folder / "broken.jsonl";
    ASSERT_EQ(run_scb("convert " + whole + " -o " + text).status, 0);
    std::string lines = file_text(text);
    const std::size_t last = lines.rfind(",[\"pair\"");
    ASSERT_NE(last, lines.npos);
    lines.erase(last, lines.find(']', last) + 1 - last);
    folder.write("broken.jsonl", lines);
    EXPECT_EQ(verdict(broken), "Frame 100: Wrong: 1 pair missed.");
}

// By default a recording shows the frame with the most pairs, and a trace the first.
TEST(ViewCommand, ShowsAFrameThatTwoFilesHave) {
    const TemporaryFolder folder;
    const std::string recording = folder / "own.scbrec", trace = folder / "trace.scbrec",
                      file = folder / "a.html", out = folder / "out";
    ASSERT_EQ(
        run_scb("trace cone --frames 60,100,140 --volume obb --records -o " + recording).status, 0);
    const nlohmann::json counts =
        nlohmann::json::parse(run_scb("trace --json " + recording).out)["frames"];
    ASSERT_GT(counts[1]["pairs"], counts[0]["pairs"]);
    ASSERT_GT(counts[1]["pairs"], counts[2]["pairs"]);
    for (const auto& [frames, shown] :
         {std::pair{"60,100,140", 100}, {"60,140", 60}, {"20,140", 140}, {"20", -1}}) {
        const std::string of_trace = std::string(" --volume scb2 --frames ") + frames;
        ASSERT_EQ(run_scb("trace cone" + of_trace + " -o " + trace).status, 0);
        for (const std::string& both : {recording + " " + trace, trace + " " + recording}) {
            const ProgramRun view = run_scb("view " + both + " --steps 0 -o " + file),
                             picture =
                                 run_scb("render rejections " + both + " --size 640x360 -o " + out);
            if (shown < 0) {
                EXPECT_EQ(view.status, 2);
                EXPECT_NE(picture.err.find("other frames"), std::string::npos) << picture.err;
                continue;
            }
            ASSERT_EQ(view.status, 0) << view.err;
            EXPECT_EQ(manifest_of(file_text(file))["frames"], nlohmann::json({shown}));
            EXPECT_EQ(columns_of(file)[1].second, 1u);
            ASSERT_EQ(picture.status, 0) << picture.err;
            const nlohmann::json index = nlohmann::json::parse(file_text(out + "/index.json"));
            EXPECT_EQ(index["frames"], nlohmann::json({shown}));
        }
    }
}

TEST(ViewCommand, RefusesWhatMakesNoSense) {
    const TemporaryFolder folder;
    for (const char* wrong :
         {"cone -o a.png", "cone --color-by surface", "cone --level 99", "cone --level 1,2",
          "cone --camera contact", "cone --opacity 2", "nothing", "cone --levels 3",
          "cone --steps -1", "cone --queries 900", "cone --compare scb", "cone --compare scb,scb",
          "cone --volume obb --compare corrected,printed", "cone cone.stl"}) {
        const ProgramRun run = run_scb(std::string("view ") + wrong, {folder.path.string()});
        EXPECT_EQ(run.status, 2) << wrong;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
    }
    EXPECT_EQ(files_in(folder.path), 0u);
    EXPECT_EQ(run_scb("view cone -o " + folder / "no/such/a.html").status, 3);
}

}  // namespace
}  // namespace scb::app
