#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "render/files/image_file.h"
#include "render/view/palette.h"
#include "tests/app/program.h"
#include "tests/png_chunks.h"

namespace scb::app {
namespace {

using nlohmann::json;

struct CompareQueries : testing::Test {
    TemporaryFolder folder;
    std::string out = folder / "out";

    ProgramRun render(const std::string& arguments) {
        return run_scb("render " + arguments + " --size 320x240 --samples 1 -o " + out);
    }
    json index_of(const std::string& arguments) {
        const ProgramRun run = render(arguments);
        EXPECT_EQ(run.status, 0) << arguments << run.err;
        return json::parse(file_text(out + "/index.json"));
    }
    /// Of a query, "12,34" a line.
    std::set<std::string> pairs_of(const std::string& arguments) {
        const std::string csv = folder / "pairs.csv";
        EXPECT_EQ(run_scb("collide " + arguments + " --pairs-out " + csv).status, 0);
        std::set<std::string> pairs;
        std::istringstream lines(file_text(csv));
        for (std::string line; std::getline(lines, line);) pairs.insert(line);
        return pairs;
    }
};

TEST_F(CompareQueries, CountsAreThoseOfEachQueryAlone) {
    for (const char* command : {"pairs ", "pairs --heat volumes ", "rejections "})
        for (const auto& [names, options] :
             {std::pair<std::string, std::array<std::string, 2>>{
                  "corrected,printed", {"--test corrected", "--test printed"}},
              {"obb,ritter", {"--volume obb", "--volume ritter"}}}) {
            const json index = index_of(command + ("spheres-l1 --frames 0,100 --compare " + names));
            for (std::size_t i = 0; i < 2; ++i) {
                const json live = json::parse(
                    run_scb("collide --json spheres-l1 --frames 0,100 " + options[i]).out);
                for (std::size_t f = 0; f < 2; ++f)
                    EXPECT_EQ(index["files"][f]["queries"][i], live["frames"][f])
                        << command << names;
                EXPECT_EQ(index["queries"][i]["volume"], live["volume"]);
            }
        }
}

TEST_F(CompareQueries, TellsPairsThatOnlyOneFound) {
    const std::set<std::string> of_corrected = pairs_of("spheres-l1 --frames 100 --test corrected"),
                                of_printed = pairs_of("spheres-l1 --frames 100 --test printed");
    std::size_t lost = 0;
    for (const std::string& pair : of_corrected) lost += !of_printed.contains(pair);
    ASSERT_GT(lost, 0u);
    const json index = index_of("pairs spheres-l1 --frames 100 --compare corrected,printed");
    EXPECT_EQ(index["files"][0]["only_in_one"], (json{lost, 0}));
    EXPECT_GT(index["files"][0]["outlined"], 0);
    const json turned = index_of("pairs spheres-l1 --frames 100 --compare printed,corrected");
    EXPECT_EQ(turned["files"][0]["only_in_one"], (json{0, lost}));
    const json same = index_of("pairs spheres-l1 --frames 100 --compare corrected,line8");
    EXPECT_EQ(same["files"][0]["only_in_one"], (json{0, 0}));
}

// Both views have a color of their own for pairs that only one found, also where the other found
// none at all.
TEST_F(CompareQueries, MarksPairsThatOnlyOneFound) {
    const auto marked = [this](const std::string& options) {
        const json index = index_of("pairs " + options);
        const render::Image image =
            render::read_png(out + "/" + index["files"][0]["file"].get<std::string>());
        std::array<int, 2> pixels{};
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                pixels[2 * x >= image.width] += render::pixel(image, x, y) == render::changed_color;
        return pixels;
    };
    for (const char* tests : {"corrected,printed", "printed,corrected"}) {
        const auto [left, right] =
            marked(std::string("spheres-l1 --frames 100 --compare ") + tests);
        EXPECT_GT(left, 20) << tests;
        EXPECT_GT(right, 20) << tests;
    }
    EXPECT_EQ(marked("spheres-l1 --frames 100 --compare corrected,line8"),
              (std::array<int, 2>{0, 0}));
}

// The segments of the pairs of both, one range after the other; each is in the id picture.
TEST_F(CompareQueries, NamesTheIdsOfThePairsOfBoth) {
    const json index = index_of("pairs spheres-l1 --frames 100 --compare corrected,printed --ids");
    const json& file = index["files"][0];
    ASSERT_EQ(file["pair_ids"].size(), 2u);
    const std::uint32_t first = file["pair_ids"][0]["first"], middle = file["pair_ids"][1]["first"];
    EXPECT_EQ(file["pair_ids"][0]["count"], file["queries"][0]["pairs"]);
    EXPECT_EQ(file["pair_ids"][1]["count"], file["queries"][1]["pairs"]);
    EXPECT_EQ(middle, first + file["pair_ids"][0]["count"].get<std::uint32_t>());
    const std::uint32_t end = middle + file["pair_ids"][1]["count"].get<std::uint32_t>();
    const render::IdImage ids =
        render::unpack_ids(render::read_png(out + "/" + file["ids"].get<std::string>()));
    std::array<int, 2> seen{};
    for (int y = 0; y < ids.height; ++y)
        for (int x = 0; x < ids.width; ++x) {
            const std::uint32_t id = render::pixel(ids, x, y);
            EXPECT_LT(id, end);
            if (id < first) continue;
            const std::size_t query = id < middle ? 0 : 1;
            ++seen[query];
            EXPECT_EQ(query == 1, x >= ids.width / 2) << "the second query is at the right";
        }
    EXPECT_GT(seen[0], 0);
    EXPECT_GT(seen[1], 0);
}

TEST_F(CompareQueries, SamePicturesFromTwoTraces) {
    const std::string first = folder / "1.scbrec", second = folder / "2.scbrec";
    const std::string scene = "spheres-l1 --frames 100,250 ";
    for (const auto& [names, option_a, option_b] :
         {std::tuple{"corrected,printed", "--test corrected ", "--test printed "},
          {"scb,ball", "--volume scb ", "--volume ball "}}) {
        ASSERT_EQ(run_scb("trace " + scene + option_a + "-o " + first).status, 0);
        ASSERT_EQ(run_scb("trace " + scene + option_b + "-o " + second).status, 0);
        for (const char* command : {"pairs ", "rejections --by share --ids "}) {
            const auto bytes = [&] {
                std::vector<std::string> all;
                const json index = json::parse(file_text(out + "/index.json"));
                for (const json& file : index["files"])
                    all.push_back(
                        png_without_texts(file_text(out + "/" + file["file"].get<std::string>())));
                EXPECT_GE(all.size(), 2u);
                return all;
            };
            const json live = index_of(command + scene + "--compare " + names);
            const std::vector<std::string> of_live = bytes();
            const json traced = index_of(command + first + " " + second + " --frames all");
            EXPECT_EQ(traced, live);
            EXPECT_EQ(bytes(), of_live);
        }
    }
}

TEST_F(CompareQueries, TracesNeedNotDifferByTestOrVolume) {
    const std::string first = folder / "1.scbrec", second = folder / "2.scbrec";
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 100 --descent area -o " + first).status, 0);
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 100 --margin 0.5 -o " + second).status, 0);
    const json index = index_of("rejections " + first + " " + second);
    EXPECT_EQ(index["compare"], (json{"0-area", "0.5-radius"}));
    EXPECT_EQ(
        index["files"][0]["file"],
        "spheres-l1_scb_0-area-vs-0.5-radius_rejections_samples-1_size-320x240_frame-0100.png");
    EXPECT_EQ(index_of("rejections " + first + " " + first)["compare"], (json{"first", "second"}));
}

// Other splits make other nodes, so that the same number says nothing.
TEST_F(CompareQueries, OfOtherSplitsOnlyTrianglesAreOutlined) {
    const std::string paper = folder / "1.scbrec", cost = folder / "2.scbrec";
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 100 -o " + paper).status, 0);
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 100 --split cost -o " + cost).status, 0);
    const std::string both = paper + " " + cost;
    EXPECT_TRUE(index_of("rejections " + both)["files"][0]["outlined"].is_null());
    const auto outlined = [&](const std::string& options) {
        return index_of("pairs " + options + both)["files"][0]["outlined"];
    };
    EXPECT_EQ(outlined(""), outlined("--leaves "));
    EXPECT_GT(outlined("--heat volumes "), 0);
    // The picked node is a node of the view: "node 12 of A, depth 9, 4 triangles".
    const std::string picked = render("rejections " + both + " --focus 1 --pick 220,90").out;
    const std::size_t at = picked.find(": node ");
    ASSERT_NE(at, std::string::npos) << picked;
    const std::string node = picked.substr(at + 2, picked.find('\n', at) - at - 2);
    const std::string index = node.substr(5, node.find(' ', 5) - 5);
    const std::string pair = node.find(" of A") != std::string::npos ? index + ",0" : "0," + index;
    EXPECT_NE(run_scb("explain " + cost + " --pair " + pair).out.find(node), std::string::npos);
    EXPECT_EQ(run_scb("explain " + paper + " --pair " + pair).out.find(node), std::string::npos);
}

TEST_F(CompareQueries, RefusesWhatCannotBeCompared) {
    const std::string trace = folder / "t.scbrec", other = folder / "o.scbrec",
                      level = folder / "l.scbrec";
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 100 -o " + trace).status, 0);
    ASSERT_EQ(run_scb("trace knots-l1 --frames 100 -o " + other).status, 0);
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 100 --level 3 -o " + level).status, 0);
    for (const auto& [arguments, said] : {
             std::pair<std::string, std::string>{"pairs spheres-l1 --compare corrected",
                                                 "two overlap tests"},
             {"pairs spheres-l1 --compare corrected,corrected", "two overlap tests"},
             {"pairs spheres-l1 --compare corrected,ball", "two overlap tests"},
             {"pairs spheres-l1 --compare a,b,c", "two overlap tests"},
             {"pairs spheres-l1 --compare corrected,printed --test extents", "leave out --test"},
             {"pairs spheres-l1 --compare scb,ball --volume obb", "leave out --volume"},
             {"pairs spheres-l1 --compare corrected,printed --volume obb", "--volume is obb"},
             {"rejections spheres-l1 --compare scb,ball --steps 100", "--steps"},
             {"pairs " + trace + " --compare scb,ball", "give two traces"},
             {"pairs " + trace + " " + other, "other scenes"},
             {"pairs " + trace + " " + level, "other levels"},
             {"pairs " + trace + " spheres-l1", "trace"},
         }) {
        const ProgramRun run = render(arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_NE(run.err.find(said), std::string::npos) << arguments << ": " << run.err;
        EXPECT_FALSE(std::filesystem::exists(out)) << arguments;
    }
}

TEST_F(CompareQueries, ATraversalIsOfOneQuery) {
    const std::string trace = folder / "t.scbrec";
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 100 -o " + trace).status, 0);
    const ProgramRun run = run_scb("render traversal " + trace + " " + trace + " -o " + out);
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("one query"), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(CompareQueries, PicksFromTheViewThatThePixelIsIn) {
    const std::string arguments =
        "rejections spheres-l1 --frames 100 --compare scb,ball --focus 1 --pick ";
    for (const char* at : {"60,90", "220,90"})
        EXPECT_NE(render(arguments + at).out.find(": node "), std::string::npos) << at;
    EXPECT_NE(render(arguments + "160,230").out.find(": nothing"), std::string::npos);
}

}  // namespace
}  // namespace scb::app
