#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

/// A working folder with an scb.json, and a folder of the user's.
struct Configured {
    TemporaryFolder here, user;

    void set_user(const std::string& text) const {
        std::filesystem::create_directories(user.path / "scb");
        user.write("scb/config.json", text);
    }
    ProgramRun run(const std::string& arguments, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> environment = {"XDG_CONFIG_HOME=" + user.path.string()};
        environment.insert(environment.end(), more.begin(), more.end());
        return run_scb(arguments, {here.path.string(), environment});
    }
};

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Config, TheCommandLineBeatsTheFolderBeatsTheUser) {
    const Configured configured;
    configured.set_user(R"({"collide": {"volume": "obb", "descent": "area"}})");
    const ProgramRun user = configured.run("collide cone --frames 80");
    EXPECT_TRUE(has(user.out, "obb hierarchies, descent by area")) << user.out << user.err;
    EXPECT_EQ(user.err, "");
    configured.here.write("scb.json", R"({"*": {"volume": "ball"}})");
    const ProgramRun folder = configured.run("collide cone --frames 80");
    EXPECT_TRUE(has(folder.out, "ball hierarchies, descent by area")) << folder.out;
    // What a stranger may have put there is said.
    EXPECT_EQ(folder.err, "scb: scb.json gives --volume ball (--no-config: not).\n");
    const ProgramRun typed = configured.run("collide cone --frames 80 --volume=scb");
    EXPECT_TRUE(has(typed.out, "scb hierarchies, test symmetric, descent by area")) << typed.out;
    const ProgramRun none = configured.run("collide cone --frames 80 --no-config");
    EXPECT_TRUE(has(none.out, "scb hierarchies, test symmetric, descent by radius")) << none.out;
    EXPECT_EQ(none.err, "");
}

TEST(Config, TheSectionThatSaysMoreHoldsAndTheEnvironmentBeatsFiles) {
    const Configured configured;
    configured.here.write("scb.json", R"({"render levels": {"size": "640x480", "samples": 1},
        "*": {"size": "320x240", "models": "from-file"}, "render": {"size": "400x300"}})");
    const json shown = json::parse(configured.run("config --json", {"SCB_MODELS=there"}).out);
    const auto value = [&](const std::string& command, const std::string& option) {
        for (const json& setting : shown["settings"])
            if (setting["command"] == "scb " + command && setting["option"] == option)
                return setting["value"].get<std::string>();
        return std::string();
    };
    EXPECT_EQ(value("render levels", "--size"), "640x480");
    EXPECT_EQ(value("render levels", "--samples"), "1");
    EXPECT_EQ(value("render pairs", "--size"), "400x300");
    EXPECT_EQ(value("tune", "--size"), "320x240");
    EXPECT_EQ(value("tune", "--samples"), "");
    EXPECT_EQ(value("collide", "--models"), "there");
    EXPECT_TRUE(has(configured.run("config").out, "from scb.json: render levels"));
    EXPECT_EQ(json::parse(configured.run("config --json --no-config").out)["settings"].size(), 0u);
}

TEST(Config, APictureIsTheOneOfTheCommandThatItNames) {
    const Configured configured;
    const std::string drawn = "render levels cone --levels 3 --no-sheet -o ";
    configured.here.write("scb.json",
                          R"({"*": {"size": "320x240", "volume": ["obb"], "ids": false}})");
    ASSERT_EQ(configured.run(drawn + "a").status, 0);
    ASSERT_EQ(configured.run("--no-config " + drawn + "b --size 320x240 --volume obb").status, 0);
    const std::string name = "cone_obb_level-03_size-320x240_frame-0060.png";
    EXPECT_EQ(file_text(configured.here.path / "a" / name),
              file_text(configured.here.path / "b" / name));
    EXPECT_NE(file_text(configured.here.path / "a" / name), "");
}

TEST(Config, WhatIsWrongIsNamedWithFileAndKey) {
    const Configured configured;
    for (const auto& [text, said] : {
             std::pair<std::string, std::string>{"{", "scb.json: line 1, column 1: not valid JSON"},
             {"[]", "scb.json: expected an object"},
             {R"({"colide": {}})", "scb.json: colide: there is no command of that name; give"},
             {R"({"collide": {"volum": "obb"}})",
              "scb.json: collide.volum: there is no option --volum of `scb collide`; see"},
             {R"({"collide": {"descent": "fast"}})",
              "scb.json: collide.descent: --descent fast: give radius, area"},
             {R"({"*": {"max-pairs": "x"}})", "scb.json: *.max-pairs: --max-pairs: 'x' is not"},
             {R"({"collide": {"threshold": 7}})", "scb.json: collide.threshold: --threshold 7: "},
             {R"({"collide": {"first": 1}})", "scb.json: collide.first: expected true or false"},
             {R"({"scb_scene": 1})", "scb.json: this is a scene"},
             // Of commands that are not run, too.
             {R"({"stats": {"sizes": 1}})", "scb.json: stats.sizes: there is no option --sizes"},
         }) {
        configured.here.write("scb.json", text);
        const ProgramRun run = configured.run("--quiet collide cone --frames 80");
        EXPECT_EQ(run.status, 2) << text;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        EXPECT_TRUE(has(run.err, "scb: error: " + said)) << text << run.err;
        EXPECT_EQ(configured.run("--quiet --no-config collide cone --frames 80").status, 0);
        EXPECT_EQ(configured.run("collide --help").status, 0);
    }
}

TEST(Config, AFileOfAStrangerNeitherWritesNorRunsAnything) {
    const Configured configured;
    for (const char* text :
         {R"({"collide": {"pairs-out": "x.csv"}})", R"({"*": {"output": "x"}})",
          R"({"*": {"open": true}})", R"({"render pairs": {"video": "x.mp4"}})",
          R"({"golden check": {"runner": "touch x"}})", R"({"golden check": {"report": "x"}})",
          R"({"golden check": {"junit": "x.xml"}})", R"({"golden update": {"all": true}})",
          R"({"golden update": {"baselines": "/"}})"}) {
        configured.here.write("scb.json", text);
        const ProgramRun run = configured.run("collide cone --frames 80");
        EXPECT_EQ(run.status, 2) << text;
        EXPECT_TRUE(has(run.err, "no file may give --")) << text << run.err;
    }
}

TEST(Config, AFileOfAStrangerLosesNoCollision) {
    const Configured configured;
    for (const char* text : {R"({"collide": {"test": "printed"}})", R"({"*": {"test": "printed"}})",
                             R"({"bench": {"test": "corrected,printed"}})"}) {
        configured.here.write("scb.json", text);
        const ProgramRun run = configured.run("--quiet collide cone --frames 80");
        EXPECT_EQ(run.status, 2) << text;
        EXPECT_TRUE(has(run.err, "no file may give --test printed, for it misses collisions"))
            << text << run.err;
        EXPECT_EQ(configured.run("collide cone --frames 80 --no-config --test printed").status, 0);
    }
    configured.here.write("scb.json", R"({"collide": {"test": "line8"}})");
    EXPECT_EQ(configured.run("collide cone --frames 80").status, 0);
}

TEST(Config, ARecordedQueryStaysAsItWas) {
    const Configured configured;
    ASSERT_EQ(configured.run("trace cone --frames 80 -o cone.scbrec").status, 0);
    configured.here.write("scb.json", R"({"*": {"volume": "obb", "descent": "area"}})");
    const ProgramRun run = configured.run("trace cone.scbrec");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, configured.run("trace cone.scbrec --no-config").out);
}

TEST(Config, DefaultsAreNotWhatSomebodyAskedFor) {
    const Configured configured;
    // A size without a folder for pictures is an error only on the command line.
    configured.here.write("scb.json", R"({"inspect": {"size": "640x480"}})");
    EXPECT_EQ(configured.run("inspect cone --frames 80").status, 0);
    EXPECT_EQ(configured.run("inspect cone --frames 80 --size 640x480").status, 2);
}

TEST(Config, GoldenRunsDoNotDependOnIt) {
    const Configured configured;
    configured.here.write("cases.json", R"({"scb_golden": 1, "cases": [
        {"name": "cone", "run": "collide", "scene": ["cone"], "frames": "80"}]})");
    const ProgramRun made = configured.run("golden update --suite cases.json --missing");
    ASSERT_EQ(made.status, 0) << made.err;
    configured.here.write("scb.json", R"({"*": {"levels": 3}})");
    const ProgramRun run = configured.run("golden check --suite cases.json");
    EXPECT_EQ(run.status, 0) << run.out << run.err;
    // Its own section is asked for.
    configured.here.write("scb.json", R"({"golden check": {"jobs": 1000}})");
    EXPECT_TRUE(has(configured.run("golden check --suite cases.json").err,
                    "scb.json: golden check.jobs: --jobs 1000"));
}

}  // namespace
}  // namespace scb::app
