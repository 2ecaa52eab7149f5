#include "golden/suite/suite.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scb/error.h"
#include "tests/temporary_folder.h"

namespace scb::golden {
namespace {

using nlohmann::json;

constexpr const char* text = R"({
  "scb_golden": 1,
  "presets": {
    "picture": {"size": "400x300", "scene": "cone", "compare": ["counts", "colors"]},
    "dark": {"preset": "picture", "arguments": ["--background", "dark"], "size": "320x240"}
  },
  "cases": [
    {"name": "levels", "preset": "dark", "run": "levels", "frames": "7", "arguments": ["--levels", "4"]},
    {"name": "summary", "preset": "picture", "run": "inspect", "frames": "0:9"},
    {"name": "counts", "run": "collide", "scene": ["a.ply", "b.ply"], "frames": "all", "volume": "obb"}
  ]
})";

class SuiteFile : public testing::Test {
  protected:
    Suite load(const json& document) const {
        return load_suite(folder.write("cases.json", document.dump()));
    }
    /// The error of the suite with that value in that place; empty if the suite is valid.
    std::string refusal(const char* pointer, const json& value) const {
        json document = json::parse(text);
        document[json::json_pointer(pointer)] = value;
        try {
            load(document);
            return "";
        } catch (const InputError& error) {
            return error.what();
        }
    }
    void expect_refused(const char* pointer, const json& value, const std::string& words) const {
        const std::string said = refusal(pointer, value);
        EXPECT_NE(said.find(words), std::string::npos) << pointer << ": " << said;
        EXPECT_TRUE(said.ends_with(".")) << said;
    }

    const TemporaryFolder folder;
};

TEST_F(SuiteFile, TakesFieldsOfPresetsOverAndOwnOnesWin) {
    const Suite suite = load(json::parse(text));
    ASSERT_EQ(suite.cases.size(), 3u);
    const GoldenCase& levels = suite.cases[0];
    EXPECT_EQ(levels.name, "levels");
    EXPECT_EQ(levels.run, GoldenRun::levels);
    EXPECT_EQ(levels.size, "320x240");
    EXPECT_EQ(levels.scene, std::vector<std::string>{"cone"});
    EXPECT_EQ(levels.arguments, (std::vector<std::string>{"--levels", "4"}));
    EXPECT_TRUE(levels.counts);
    EXPECT_FALSE(levels.ids);
    EXPECT_TRUE(levels.colors);
    EXPECT_EQ(suite.cases[1].size, "400x300");
}

TEST_F(SuiteFile, ComparesAllThatARunMakesUnlessTold) {
    json document = json::parse(text);
    document["presets"]["picture"].erase("compare");
    const Suite suite = load(document);
    const auto compared = [](const GoldenCase& golden) {
        return std::vector<bool>{golden.counts, golden.ids, golden.colors};
    };
    EXPECT_EQ(compared(suite.cases[0]), (std::vector<bool>{true, true, true}));
    EXPECT_EQ(compared(suite.cases[1]), (std::vector<bool>{true, false, true}));
    EXPECT_EQ(compared(suite.cases[2]), (std::vector<bool>{true, false, false}));
}

TEST_F(SuiteFile, RefusesWhatIsNoSuite) {
    expect_refused("/presets", 5, "an object of presets");
    expect_refused("/presets/picture", 5, "presets.picture");
    expect_refused("/presets/unused", {{"nonsense", 1}}, "nonsense");
    expect_refused("/presets/unused", {{"name", "x"}}, "a preset has no name");
    expect_refused("/cases", json::array(), "there is no case");
    expect_refused("/cases", json::object(), "a list of cases");
    expect_refused("/scb_golden", 3, "scb_golden");
}

TEST_F(SuiteFile, RefusesLongChainsOfPresets) {
    json document = json::parse(text);
    const auto use_chain_of = [&](int presets) {
        document["presets"]["p1"] = document["presets"]["picture"];
        for (int i = 2; i <= presets; ++i)
            document["presets"]["p" + std::to_string(i)] = {
                {"preset", "p" + std::to_string(i - 1)}};
        document["cases"][0]["preset"] = "p" + std::to_string(presets);
    };
    use_chain_of(16);
    EXPECT_EQ(load(document).cases.size(), 3u);
    // As many as would take all of the stack.
    use_chain_of(30000);
    EXPECT_THROW(load(document), InputError);
}

TEST_F(SuiteFile, RefusesNamesThatOtherFilesOfABaselineCouldHave) {
    for (const char* name : {"margin-0.2", "levels.ids", "a.b", ".hidden", "-o", "a/b", "", "a b"})
        expect_refused("/cases/0/name", name, "cases[0].name");
    expect_refused("/cases/0/name", "margin-0.2", "without '.'");
    EXPECT_EQ(refusal("/cases/0/name", "Margin_0-2"), "");
}

TEST_F(SuiteFile, RefusesPicturesOfSeveralFramesOrVolumes) {
    for (const char* frames : {"100,110", "0:99:10", "all", "100,100"})
        expect_refused("/cases/0/frames", frames, "a picture is of one");
    expect_refused("/cases/0/frames", 7, "a text");
    for (const char* place : {"/cases/0/volume", "/cases/2/volume"})
        expect_refused(place, "scb,ball", "one volume");
    // A summary is one picture of many frames.
    EXPECT_EQ(refusal("/cases/1/frames", "all"), "");
}

TEST_F(SuiteFile, RefusesToCompareWhatTheRunDoesNotMake) {
    expect_refused("/cases/1/compare", {"counts", "ids"}, "inspect makes none");
    expect_refused("/cases/2/compare", {"counts", "colors"}, "collide draws none");
    expect_refused("/cases/2/compare", {"ids"}, "collide makes none");
    expect_refused("/cases/0/compare", json::array(), "some of counts, ids, colors");
    expect_refused("/cases/0/compare", {"looks"}, "counts, ids or colors");
    const json tolerance = {{"max_channel_delta", 1}, {"max_pixels", 2}};
    expect_refused("/cases/2/tolerance", tolerance, "none are compared");
    EXPECT_EQ(refusal("/cases/0/tolerance", tolerance), "");
    json document = json::parse(text);
    document["cases"][0]["tolerance"] = tolerance;
    document["cases"][0]["compare"] = {"counts", "ids"};
    EXPECT_THROW(load(document), InputError);
}

TEST_F(SuiteFile, RefusesArgumentsThatSayWhereOrHowToWrite) {
    for (const char* word : {"-o", "-oout", "--output=x", "--json", "--frames", "--jobs=2"})
        expect_refused("/cases/0/arguments", json::array({word}), "is not for cases");
}

TEST_F(SuiteFile, SizesAreWithinWhatPicturesMayHave) {
    for (const char* size : {"319x240", "320x239", "513x240", "320x240x2", "320", "axb"})
        expect_refused("/cases/0/size", size, "320x240");
    EXPECT_EQ(refusal("/cases/0/size", "512x512"), "");
}

TEST_F(SuiteFile, PicturesOfScenesHaveNoPanelSinceTheSecondVersion) {
    json document = json::parse(text);
    document["presets"]["picture"].erase("size");
    document["presets"]["dark"].erase("size");
    const auto drawn = [&](std::size_t which) {
        const GoldenCase golden = load(document).cases[which];
        return golden.size + (golden.panel ? " with panel" : " alone");
    };
    EXPECT_EQ(drawn(0), "320x240 with panel");
    EXPECT_EQ(drawn(1), "320x240 with panel");
    document["scb_golden"] = 2;
    EXPECT_EQ(drawn(0), "240x180 alone");
    EXPECT_EQ(drawn(1), "512x384 with panel");
    document["presets"]["picture"]["panel"] = true;
    EXPECT_EQ(drawn(0), "512x384 with panel");
    document["cases"][0]["panel"] = false;
    document["cases"][0]["size"] = "64x64";
    EXPECT_EQ(drawn(0), "64x64 alone");
    // For a run without a view of a scene, a size without a panel is too small.
    document["presets"]["picture"]["panel"] = false;
    document["cases"][1]["size"] = "240x180";
    EXPECT_THROW(load(document), InputError);
}

TEST_F(SuiteFile, NamesFilesAsTheyAreOpenedHereAndAsItHasThem) {
    const Suite suite = load(json::parse(text));
    EXPECT_EQ(suite.cases[2].scene, (std::vector<std::string>{folder / "a.ply", folder / "b.ply"}));
    EXPECT_EQ(suite.cases[2].own_scene, (std::vector<std::string>{"a.ply", "b.ply"}));
    EXPECT_EQ(suite.cases[0].own_scene, std::vector<std::string>{"cone"});
}

}  // namespace
}  // namespace scb::golden
