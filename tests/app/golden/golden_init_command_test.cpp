#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;

/// A folder with the parts of the sample, as a stranger has parts of their own.
class GoldenInitCommand : public testing::Test {
  protected:
    GoldenInitCommand() {
        for (const char* file : {"bracket.json", "bracket.ply", "pin.obj"})
            fs::copy_file(fs::path(SCB_SOURCE_DIR) / "scenes/samples" / file, folder.path / file);
    }
    ProgramRun golden(const std::string& arguments) const {
        return run_scb("golden " + arguments, {folder.path.string()});
    }
    std::string text(const std::string& file) const { return file_text(folder.path / file); }
    bool is_there(const std::string& file) const {
        return fs::exists(fs::symlink_status(folder.path / file));
    }
    /// All that is in the folder, by its path from there.
    std::vector<std::string> all() const {
        std::vector<std::string> paths;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder.path))
            paths.push_back(entry.path().lexically_relative(folder.path).string());
        std::sort(paths.begin(), paths.end());
        return paths;
    }
    nlohmann::json cases(const std::string& suite) const {
        return nlohmann::json::parse(text(suite))["cases"];
    }
    void refuses(const std::string& arguments, const std::string& sentence) const {
        const std::vector<std::string> before = all();
        const ProgramRun run = golden("init " + arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_NE(run.err.find(sentence), std::string::npos) << arguments << "\n" << run.err;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        EXPECT_EQ(all(), before) << arguments;
    }

    const TemporaryFolder folder;
};

/// Runs what was written as it says, from nothing to green and red.
TEST_F(GoldenInitCommand, WritesASuiteThatIsGreenAndTurnsRed) {
    const ProgramRun init = golden("init bracket.json");
    ASSERT_EQ(init.status, 0) << init.err;
    for (const char* step : {"  scb golden update --all\n",
                             "  git add golden .github/workflows/scb-golden.yml bracket.json "
                             "bracket.ply pin.obj\n",
                             "  scb golden check --report out/report\n"})
        EXPECT_NE(init.out.find(step), std::string::npos) << init.out;
    EXPECT_TRUE(is_there("golden/baselines/.gitattributes"));
    EXPECT_EQ(golden("check").status, 1) << "there are no baselines";
    const ProgramRun update = golden("update --all");
    EXPECT_EQ(update.status, 0) << update.err;
    const ProgramRun check = golden("check");
    EXPECT_EQ(check.status, 0) << check.out;
    EXPECT_NE(check.out.find("5 cases: 5 same"), std::string::npos) << check.out;
    // Every error of the selftest shows.
    EXPECT_EQ(golden("selftest").status, 0);
    EXPECT_TRUE(is_there("golden/baselines/.gitattributes")) << "an update leaves it";

    std::string scene = text("bracket.json");
    const std::size_t at = scene.find("\"degrees\": 1");
    ASSERT_NE(at, std::string::npos);
    write_text(folder.path / "bracket.json", scene.replace(at, 12, "\"degrees\": 2"));
    const ProgramRun red = golden("check --report out/report");
    EXPECT_EQ(red.status, 1);
    EXPECT_NE(red.out.find("counts: different. Body pin turned: 1 degree."), std::string::npos)
        << red.out;
    EXPECT_TRUE(is_there("out/report/report.html"));
}

TEST_F(GoldenInitCommand, NamesFilesFromTheFolderOfTheSuite) {
    fs::create_directories(folder.path / "parts");
    fs::rename(folder.path / "pin.obj", folder.path / "parts/pin.obj");
    ASSERT_EQ(golden("init bracket.ply parts/pin.obj --pose 1,0,0,0,0,1,0,-99.5,0,0,1,44 --ci none "
                     "-o tests/golden/")
                  .status,
              0);
    for (const nlohmann::json& one : cases("tests/golden/cases.json")) {
        if (one.contains("scene")) {
            EXPECT_EQ(one["scene"], nlohmann::json({"../../bracket.ply", "../../parts/pin.obj"}));
        }
        EXPECT_EQ(one["arguments"][1], "1,0,0,0,0,1,0,-99.5,0,0,1,44") << one;
    }
    EXPECT_FALSE(is_there(".github"));
    EXPECT_EQ(golden("update --all --suite tests/golden/cases.json").status, 0);
    EXPECT_EQ(golden("check --suite tests/golden/cases.json").status, 0);
}

/// The names of the bodies come before A and B, which mean the first and the second.
TEST_F(GoldenInitCommand, KeepsLogsWithTheirBodies) {
    for (const char* body : {"A", "B"}) {
        fs::copy_file(folder.path / "pin.obj", folder.path / (std::string(body) + ".obj"));
        write_text(folder.path / (std::string(body) + ".csv"), "0,0,0,0,0,0,1\n");
    }
    ASSERT_EQ(golden("init B.obj A.obj --poses B=B.csv,A=A.csv --ci none").status, 0);
    for (const nlohmann::json& one : cases("golden/cases.json"))
        EXPECT_EQ(one["arguments"][1], "B=../B.csv,A=../A.csv") << one;
}

TEST_F(GoldenInitCommand, AsksOfASceneWhatItHas) {
    ASSERT_EQ(golden("init pin.obj --ci none -o one").status, 0);
    ASSERT_EQ(cases("one/cases.json").size(), 2u) << "one body has levels only";
    write_text(folder.path / "three.json", R"({"scb_scene": 1, "name": "three",
        "models": [{"name": "box", "box": {}}], "bodies": [{"name": "a", "model": "box"},
        {"name": "b", "model": "box", "position": [0.5, 0.5, 0.5]}, {"name": "c", "model": "box"}]})");
    ASSERT_EQ(golden("init three.json --ci none -o three").status, 0);
    const nlohmann::json three = cases("three/cases.json");
    ASSERT_EQ(three.size(), 4u) << "a box has no level 5";
    EXPECT_FALSE(three[0].contains("arguments")) << "counts are of all pairs of bodies";
    EXPECT_EQ(three[1]["arguments"], nlohmann::json({"--bodies", "a,b"}));
    EXPECT_FALSE(three[0].contains("frames"));
    for (const char* suite : {"one", "three"}) {
        const std::string words = std::string(" --suite ") + suite + "/cases.json";
        EXPECT_EQ(golden("update --all" + words).status, 0) << suite;
        EXPECT_EQ(golden("check" + words).status, 0) << suite;
    }
    ASSERT_EQ(golden("init --ci none").status, 0) << "a built-in scene";
    EXPECT_EQ(golden("update --all").status, 0);
    EXPECT_EQ(golden("selftest").status, 0);
}

/// From the usual direction a wide plate hides the small box behind it.
TEST_F(GoldenInitCommand, LooksAtPairsFromWhereTheContactIsVisible) {
    const auto scene = [this](const std::string& name, const std::string& more) {
        write_text(folder.path / (name + ".json"), R"({"scb_scene": 1, "name": ")" + name + R"(",
            "models": [{"name": "plate", "box": {"size": [6, 0.2, 6]}},
                       {"name": "box", "box": {"size": [0.6, 0.6, 0.6]}}],
            "bodies": [{"name": "a", "model": "plate"},
                       {"name": "b", "model": "box", "position": [0.05, 0.35, 0.05]}])" +
                                                       more + "}");
        EXPECT_EQ(golden("init " + name + ".json --ci none -o " + name).status, 0);
        return cases(name + "/cases.json");
    };
    const nlohmann::json open = scene("open", "");
    for (const std::size_t picture : {1u, 2u}) {
        ASSERT_EQ(open[picture]["arguments"][0], "--camera") << open;
        const std::string camera = open[picture]["arguments"][1];
        ASSERT_TRUE(camera.starts_with("orbit:")) << camera;
        const double azimuth = std::stod(camera.substr(6)) * 3.14159265358979 / 180;
        EXPECT_LT(std::cos(azimuth), 0) << "from behind the plate: " << camera;
    }
    EXPECT_FALSE(open[0].contains("arguments")) << "counts need no camera";
    EXPECT_EQ(golden("update --all --suite open/cases.json").status, 0);
    EXPECT_EQ(golden("check --suite open/cases.json").status, 0);
    const nlohmann::json own = scene("own", R"(, "camera": {"azimuth": 10})");
    EXPECT_FALSE(own[1].contains("arguments")) << own;
}

TEST_F(GoldenInitCommand, OverwritesNothing) {
    ASSERT_EQ(golden("init bracket.json").status, 0);
    refuses("bracket.json", "golden/cases.json: this file exists, and nothing is overwritten; ");
    refuses("bracket.json -o other", ".github/workflows/scb-golden.yml: this file exists");
    fs::create_symlink("nowhere", folder.path / "linked");
    refuses("bracket.json --ci none -o linked", "linked: this is no folder");
    refuses("bracket.json --ci none -o pin.obj/suite", "pin.obj: this is no folder");
    // The jobs of GitLab go beside what is there, and then nowhere.
    write_text(folder.path / ".gitlab-ci.yml", "mine: {script: [make]}\n");
    const ProgramRun beside = golden("init bracket.json --ci gitlab -o second");
    EXPECT_EQ(beside.status, 0) << beside.err;
    EXPECT_NE(beside.out.find("include: [{local: .gitlab/scb-golden.yml}]"), std::string::npos);
    EXPECT_EQ(text(".gitlab-ci.yml"), "mine: {script: [make]}\n");
    refuses("bracket.json --ci gitlab -o third", ".gitlab/scb-golden.yml: this file exists");
}

TEST_F(GoldenInitCommand, RefusesWhatCiCouldNotDo) {
    refuses("nothing.json", "nothing.json: there is no such file");
    refuses("bracket.json --ci travis", "--ci travis: give github, gitlab, both or none.");
    refuses("bracket.json --scb scb", "--scb scb: give the repository of scb on GitHub as");
    refuses("bracket.json -o 'a b'", "-o a b: files of CI name this folder; give one of letters");
    refuses("bracket.json -o ../golden", "outside of the folder where you are");
    const TemporaryFolder elsewhere;
    fs::copy_file(folder.path / "pin.obj", elsewhere.path / "pin.obj");
    refuses((elsewhere.path / "pin.obj").string(), "this file is outside of the folder");
    fs::create_directories(folder.path / ".git");
    fs::create_directories(folder.path / "inner");
    const ProgramRun inner = run_scb("golden init", {folder / "inner"});
    EXPECT_EQ(inner.status, 2);
    EXPECT_NE(inner.err.find("CI reads its files at the root of the repository"), std::string::npos)
        << inner.err;
    EXPECT_TRUE(fs::is_empty(folder.path / "inner"));
}

TEST_F(GoldenInitCommand, LeavesNothingWhereAFileCannotBeWritten) {
    const std::vector<std::string> before = all();
    // The limit, 1024 bytes, lets the suite and not the jobs be written.
    const ProgramRun run = run_scb_process("golden init pin.obj --ci gitlab",
                                           "cd " + folder.path.string() + " && ulimit -f 2 &&");
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("Cannot write \".gitlab-ci.yml\""), std::string::npos) << run.err;
    EXPECT_EQ(all(), before);
}

/// YAML, where this system can read it; and that the workflow gives the action inputs that it has.
TEST_F(GoldenInitCommand, WritesFilesThatCiReads) {
    if (std::system("python3 -c 'import yaml' 2>/dev/null") != 0) GTEST_SKIP() << "no yaml";
    ASSERT_EQ(golden("init bracket.json --ci both --scb someone/scb -o tests/golden").status, 0);
    write_text(folder.path / "read.py", R"(import sys, yaml
action = yaml.safe_load(open(sys.argv[1]))
github = yaml.safe_load(open(".github/workflows/scb-golden.yml"))
gitlab = yaml.safe_load(open(".gitlab-ci.yml"))
steps = [s for job in github["jobs"].values() for s in job["steps"] if "scb-golden" in s["uses"]]
assert len(steps) == 2, steps
for step in steps:
    assert step["uses"].startswith("someone/scb/.github/actions/scb-golden@v"), step
    assert step["uses"].endswith(step["with"]["version"]), step
    assert set(step["with"]) <= set(action["inputs"]), step
assert steps[0]["with"]["suite"] == "tests/golden/cases.json"
assert gitlab[".scb-golden"]["variables"]["SCB_SUITE"] == "tests/golden/cases.json"
assert "someone/scb" in gitlab[".scb-golden"]["variables"]["SCB_PACKAGE"]
for job in gitlab.values():
    for line in job.get("before_script", []) + job.get("script", []):
        assert isinstance(line, str), line
)");
    const std::string action =
        (fs::path(SCB_SOURCE_DIR) / ".github/actions/scb-golden/action.yml").string();
    EXPECT_EQ(std::system(("cd " + folder.path.string() + " && python3 read.py " + action).c_str()),
              0);
}

}  // namespace
}  // namespace scb::app
