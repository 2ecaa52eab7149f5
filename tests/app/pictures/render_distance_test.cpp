#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "render/files/image_file.h"
#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

class RenderDistance : public testing::Test {
  protected:
    TemporaryFolder folder_;
    std::string out_ = folder_ / "out";

    json index_of(const std::string& arguments) const {
        const ProgramRun run = run_scb("render distance " + arguments + " --samples 1 -o " + out_);
        EXPECT_EQ(run.status, 0) << arguments << run.err;
        return json::parse(file_text(out_ + "/index.json"));
    }
};

TEST_F(RenderDistance, HasTheNumbersOfTheDistanceCommand) {
    for (const char* options : {"", "--volume obb --order nearest", "--within 0.06"}) {
        SCOPED_TRACE(options);
        const std::string arguments = "spheres-l1 --frames 0,2,100 " + std::string(options);
        const json index = index_of(arguments + " --size 320x240");
        const json live = json::parse(run_scb("distance --json " + arguments).out);
        ASSERT_EQ(index["files"].size(), 3u);
        for (std::size_t i = 0; i < 3; ++i)
            for (const auto& [key, value] : live["frames"][i].items())
                if (key != "inside" && key != "signed_distance" && key != "rounding") {
                    EXPECT_EQ(index["files"][i][key], value) << key;
                }
        for (const char* key : {"scene", "volume", "query", "descent", "split"})
            EXPECT_EQ(index.value(key, json()), live.value(key, json())) << key;
    }
}

/// The pixels of each id in the first picture.
std::map<std::uint32_t, int> pixels_of(const json& index, const std::string& folder) {
    const render::IdImage ids = render::unpack_ids(
        render::read_png(folder + "/" + index["files"][0]["ids"].get<std::string>()));
    std::map<std::uint32_t, int> pixels;
    for (const std::uint32_t id : ids.ids) ++pixels[id];
    return pixels;
}

TEST_F(RenderDistance, ShowsAShortLineClosely) {
    // The line is a fortieth of the bodies, and at least a sixth of the view.
    const json index = index_of("spheres-l1 --frames 0 --ids --no-panel --size 240x160");
    const std::uint32_t line = index["files"][0]["pair_ids"]["first"];
    EXPECT_EQ(index["files"][0]["pair_ids"]["count"], 1);
    std::map<std::uint32_t, int> pixels = pixels_of(index, out_);
    EXPECT_GT(pixels[line], 40);
    EXPECT_LT(pixels[line], 1000);
    // The closest triangles are there, too.
    const json& triangles = index["files"][0]["triangles"];
    for (std::size_t side = 0; side < 2; ++side) {
        const std::uint32_t first = index["ids"][2 + side]["first"];
        EXPECT_GT(pixels[first + triangles[side].get<std::uint32_t>()], 0) << side;
    }
}

/// The number that follows a text in a picture.
std::uint64_t number_after(const std::string& svg, const std::string& text) {
    const std::size_t at = svg.find(">" + text + "</text>");
    if (at == std::string::npos) return 0;
    std::uint64_t number = 0;
    for (std::size_t i = svg.find('>', svg.find("<text", at)) + 1; i < svg.size(); ++i) {
        if (svg[i] == ',' && i + 1 < svg.size() && svg[i + 1] != ' ') continue;
        if (svg[i] < '0' || svg[i] > '9') break;
        number = 10 * number + static_cast<std::uint64_t>(svg[i] - '0');
    }
    return number;
}

TEST_F(RenderDistance, HeatCountsTheTestsOfPairsDividedInVain) {
    const auto drawn = [this](const std::string& options) {
        const json index = index_of("spheres-l1 --frames 0 --svg " + options);
        EXPECT_EQ(index["options"].value("heat", ""), options.empty() ? "" : options.substr(7));
        return file_text(out_ + "/" + index["files"][0]["svg"].get<std::string>());
    };
    // A division leads to two tests.
    const std::uint64_t in_vain = number_after(drawn(""), "of these in vain");
    EXPECT_GT(in_vain, 10u);
    EXPECT_EQ(number_after(drawn("--heat wasted"), "wasted N_v"), 2 * in_vain);
    // Each test has one triangle of A at least, and the roots have all.
    EXPECT_GT(number_after(drawn("--heat volumes"), "most tests"), 10u);
}

TEST_F(RenderDistance, RefusesTracesAndWrongNumbers) {
    const auto error = [this](const std::string& arguments) {
        const ProgramRun run = run_scb("render distance " + arguments + " -o " + out_);
        EXPECT_EQ(run.status, 2) << arguments;
        return run.err;
    };
    EXPECT_NE(error("spheres-l1 --within -1").find("0 or more"), std::string::npos);
    EXPECT_NE(error("spheres-l1 --within 1 --limit 2").find("--limit"), std::string::npos);
    EXPECT_NE(error("spheres-l1 --heat-end 10").find("give at least 2, and --heat"),
              std::string::npos);
    EXPECT_NE(error("spheres-l1 --bodies A,A").find("name two bodies"), std::string::npos);
    const std::string trace = folder_ / "t.scbrec";
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 0 -o " + trace).status, 0);
    EXPECT_NE(error(trace).find("give its scene"), std::string::npos);
}

}  // namespace
}  // namespace scb::app
