#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/inspect/inspect_run.h"

namespace scb::app {
namespace {

using nlohmann::json;

/// The report in a folder. The page of `scb view` has another name.
std::string html_in(const std::string& folder, const std::string& ending = ".html") {
    std::string text;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(ending) && name.ends_with("_view.html") == (ending == "_view.html"))
            text += file_text(entry.path());
    }
    return text;
}

/// The texts between the two marks, one after the other.
std::vector<std::string> all_between(const std::string& text, const std::string& begin,
                                     const std::string& end) {
    std::vector<std::string> found;
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
        at += begin.size();
        found.push_back(text.substr(at, text.find(end, at) - at));
    }
    return found;
}

TEST(InspectPage, NamesAMeshOnceInTitles) {
    const TemporaryFolder folder;
    const std::string mesh = SCB_SOURCE_DIR "/scenes/samples/bracket.ply";
    const ProgramRun run =
        run_scb("inspect " + mesh + " " + mesh + " --pose 1,0,0,30,0,1,0,0,0,0,1,70 --top 1 -o " +
                folder / "out");
    ASSERT_EQ(run.status, 0) << run.err;
    for (const char* ending : {".html", "_view.html"}) {
        const std::string html = html_in(folder / "out", ending);
        EXPECT_NE(html.find("bracket with itself"), std::string::npos) << ending;
        EXPECT_EQ(html.find("bracket-bracket ·"), std::string::npos) << ending;
    }
}

TEST(InspectPage, WritesAPageWithPicturesOfTheWorstPairs) {
    const TemporaryFolder folder;
    const std::string arguments = "spheres-l1 --frames 60,100 --top 2 --test corrected";
    const ProgramRun run = run_scb("inspect " + arguments + " --size 640x360 -o " + folder / "out");
    ASSERT_EQ(run.status, 0) << run.err;
    // The run without pictures prints the same numbers.
    EXPECT_EQ(run.out.find(run_scb("inspect " + arguments).out), 0u);

    const json index = json::parse(file_text(folder / "out/index.json"));
    json found = inspect(arguments);
    std::set<std::string> pictures;
    for (json& pair : found["worst"]) {
        const auto frame = pair["frame"].get<int>(), a = pair["nodes"][0].get<int>(),
                   b = pair["nodes"][1].get<int>();
        char name[150];
        std::snprintf(name, sizeof name,
                      "spheres-l1_scb_explain_test-corrected_size-640x360_frame-%04d_A-%d_B-%d.png",
                      frame, a, b);
        pair["file"] = name;
        pictures.insert(name);
    }
    ASSERT_EQ(pictures.size(), 4u);
    for (const char* key : {"frames", "sum", "depths", "worst", "other_tests"})
        EXPECT_EQ(index[key], found[key]) << key;
    pictures.insert("spheres-l1_scb_inspect_test-corrected_size-640x360_frames-60-100.png");
    char bodies[100];
    std::snprintf(bodies, sizeof bodies,
                  "spheres-l1_scb_inspect_bodies_test-corrected_size-640x360_frame-%04d.png",
                  found["frames"][0]["frame"].get<int>());
    pictures.insert(bodies);
    std::set<std::string> listed;
    for (const json& file : index["files"]) listed.insert(file["file"].get<std::string>());
    EXPECT_EQ(listed, pictures);

    // The page names them all, and nothing else.
    const std::string html = html_in(folder / "out");
    const std::vector<std::string> sources = all_between(html, "<img src=\"", "\"");
    EXPECT_EQ(std::set<std::string>(sources.begin(), sources.end()), pictures);
    EXPECT_EQ(sources.front(), bodies);
    for (const std::string& file : sources)
        EXPECT_TRUE(std::filesystem::exists(folder / ("out/" + file))) << file;
    EXPECT_EQ(html.find("{{"), std::string::npos);
    EXPECT_EQ(html.find("http"), std::string::npos) << "opens without a network";

    // Its commands work as they stand.
    std::vector<std::string> commands = all_between(html, "<code>", "</code>");
    ASSERT_EQ(commands.size(), 7u);
    EXPECT_EQ(commands.front(), found["settings"]["layout_command"]);
    EXPECT_EQ(run_scb(commands.front().substr(4)).status, 0);
    const std::vector<std::string> best = all_between(html, "<tr class=\"best\"><td>", ", best<");
    ASSERT_EQ(best.size(), 1u);
    EXPECT_TRUE(best.front().ends_with(", packed")) << best.front();
    EXPECT_EQ(commands[1].rfind("scb::build_packed&lt;scb::", 0), 0u) << "a line of C++";
    commands.erase(commands.begin(), commands.begin() + 2);
    EXPECT_EQ(commands.back(),
              "scb inspect spheres-l1 --test corrected --frames 60,100 --top 2 "
              "--size 640x360 -o DIR");
    commands.pop_back();
    for (std::size_t i = 0; i < commands.size(); ++i) {
        ASSERT_EQ(commands[i].rfind("scb explain ", 0), 0u);
        const json explained = json::parse(run_scb(commands[i].substr(4) + " --json").out)[0];
        EXPECT_EQ(explained["frame"], found["worst"][i]["frame"]);
        EXPECT_EQ(explained["exact"], found["worst"][i]["exact"]);
        EXPECT_EQ(explained["stage"]["corrected"], "overlapping");
    }
}

TEST(InspectPage, OfARecordingHasTheVerdictAndTheWorstPairs) {
    const TemporaryFolder folder;
    const std::string recording = folder / "r.scbrec";
    ASSERT_EQ(run_scb("trace --records spheres-l1 --frames 60,100 -o " + recording).status, 0);
    const ProgramRun run =
        run_scb("inspect " + recording + " --size 640x360 --top 2 -o " + folder / "out");
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string html = html_in(folder / "out");
    EXPECT_NE(html.find("<p class=\"verdict\">"), std::string::npos) << html;
    EXPECT_EQ(html.find("{{"), std::string::npos);
    const std::vector<std::string> sources = all_between(html, "<img src=\"", "\"");
    EXPECT_EQ(sources.size(), 2u + 4u) << "the bodies, all frames, and two pairs for each reason";
    for (const std::string& file : sources)
        EXPECT_TRUE(std::filesystem::exists(folder / ("out/" + file))) << file;
    EXPECT_FALSE(html_in(folder / "out", "_view.html").empty());
    // The page of `scb view` has one frame, so that only pairs of this frame lead to it.
    const std::string worst = inspect(recording)["waste"]["frames"][0]["frame"].dump();
    std::size_t led = 0;
    for (const std::string& link : all_between(html, "<a href=\"", "\"")) {
        if (link.find("_view.html#frame=") == std::string::npos) continue;
        EXPECT_NE(link.find("#frame=" + worst + "&"), std::string::npos) << link;
        ++led;
    }
    EXPECT_GT(led, 0u);
    EXPECT_LT(led, 4u) << "a pair is of the other frame";
    EXPECT_EQ(all_between(html, "_view.html#show=", "\"").size(), 1u);
    // The commands of its pairs work as they stand.
    std::size_t explained = 0;
    for (const std::string& command : all_between(html, "<code>", "</code>")) {
        if (!command.starts_with("scb explain ")) continue;
        EXPECT_EQ(run_scb(command.substr(4)).status, 0) << command;
        ++explained;
    }
    EXPECT_EQ(explained, 4u);
}

TEST(InspectPage, OfAWrongRecordingShowsTheFirstOfEachKindOfProblem) {
    const TemporaryFolder folder;
    const std::string recording = folder / "r.scbrec";
    ASSERT_EQ(
        run_scb("trace --records spheres-l1 --frames 60 --test printed -o " + recording).status, 0);
    const ProgramRun run = run_scb("inspect " + recording + " --size 640x360 -o " + folder / "out");
    ASSERT_EQ(run.status, 1) << run.err;
    const std::string html = html_in(folder / "out");
    EXPECT_NE(html.find("<p class=\"alarm\">Wrong: "), std::string::npos) << html;
    EXPECT_EQ(html.find("id=\"frames\""), std::string::npos) << "the waste";
    const std::vector<std::string> sources = all_between(html, "<img src=\"", "\"");
    ASSERT_FALSE(sources.empty());
    for (const std::string& file : sources)
        EXPECT_TRUE(std::filesystem::exists(folder / ("out/" + file))) << file;
}

TEST(InspectPage, LeadsToAPageOfThePairs) {
    const TemporaryFolder folder;
    const std::string arguments = "cone --volume obb --frames 90:110:10 --top 2 --size 320x240 -o ",
                      name = "out/cone_obb_inspect_size-320x240_frames-90-to-110-by-10_top-2";
    ASSERT_EQ(run_scb("inspect " + arguments + folder / "out").status, 0);
    const std::string html = file_text(folder / (name + ".html"));
    std::vector<std::string> links = all_between(html, "<a href=\"", "\"");
    std::erase_if(links, [](const std::string& link) {
        return link.find("_view.html") == std::string::npos;
    });
    ASSERT_EQ(links.size(), 3u);
    EXPECT_TRUE(links[0].ends_with("_view.html#show=verdicts"));
    EXPECT_NE(links[1].find("_view.html#frame="), std::string::npos);
    EXPECT_NE(links[1].find("nodes="), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder / (name + "_view.html")));
    ASSERT_EQ(run_scb("inspect --no-view " + arguments + folder / "out").status, 0);
    EXPECT_EQ(file_text(folder / (name + ".html")).find("_view.html"), std::string::npos);
}

TEST(InspectPage, WritesTablesOfFramesAndPairs) {
    const TemporaryFolder folder;
    const std::string arguments = "line-8 --test printed --frames 84:96:4 --top 3";
    ASSERT_EQ(run_scb("inspect " + arguments + " --size 320x240 -o " + folder / "out").status, 1);
    const json found = inspect(arguments, 1);
    const std::vector<std::string>
        frames = lines(file_text(
            folder /
            "out/"
            "line-8_scb_inspect_test-printed_size-320x240_frames-84-to-96-by-4_top-3_frames.csv")),
        pairs = lines(file_text(
            folder /
            "out/"
            "line-8_scb_inspect_test-printed_size-320x240_frames-84-to-96-by-4_top-3_pairs.csv"));
    ASSERT_EQ(frames.size(), 5u);
    EXPECT_EQ(frames[0],
              "frame,pairs,n_v,n_p,passed,true,fit,test,wrongly_rejected,missed_pairs,operations,"
              "wasted_n_v,wasted_n_p,wasted_operations,wasted_by_test_n_v,wasted_by_test_n_p,"
              "wasted_by_test_operations");
    for (std::size_t i = 0; i < 4; ++i) {
        const int number = 84 + 4 * static_cast<int>(i);
        for (const json& frame : found["frames"]) {
            if (frame["frame"] != number) continue;
            std::string row = std::to_string(number);
            for (const char* key : {"pairs", "n_v", "n_p", "passed"})
                row += "," + frame[key].dump();
            for (const char* reason : {"true", "fit", "test"})
                row += "," + std::to_string(count(frame, reason));
            for (const char* key : {"wrongly_rejected", "missed_pairs"})
                row += "," + frame[key].dump();
            row += "," + frame["work"]["operations"].dump();
            for (const json& work : {frame["wasted"], frame["wasted_by"]["test"]})
                for (const char* key : {"n_v", "n_p", "operations"}) row += "," + work[key].dump();
            EXPECT_EQ(frames[i + 1], row);
        }
    }
    ASSERT_EQ(pairs.size(), 10u);
    const std::size_t columns = all_between("," + pairs[0], ",", ",").size();
    for (const std::string& row : pairs)
        EXPECT_EQ(static_cast<std::size_t>(std::count(row.begin(), row.end(), ',')) + 1, columns)
            << row;
    for (std::size_t i = 0; i < 9; ++i) {
        const json& pair = i < 6 ? found["worst"][i] : found["worst_rejections"][i - 6];
        EXPECT_EQ(pairs[i + 1].rfind(pair["frame"].dump() + "," + pair["nodes"][0].dump() + "," +
                                         pair["nodes"][1].dump() + ",",
                                     0),
                  0u)
            << pairs[i + 1];
    }
    // What was missed is what the other tests find.
    EXPECT_EQ(found["sum"]["pairs"].get<int>() + found["sum"]["missed_pairs"].get<int>(),
              found["other_tests"][0]["pairs"].get<int>());
    EXPECT_GT(found["sum"]["missed_pairs"], 0);
    EXPECT_NE(html_in(folder / "out").find("Rejected wrongly"), std::string::npos);
}

TEST(InspectPage, NamesFromOutsideStayText) {
    const TemporaryFolder folder;
    const std::string scene = folder / "it's <b>.json";
    write_text(scene, R"({"scb_scene": 1, "name": "names", "frames": 1,
        "models": [{"name": "m", "icosphere": {"subdivisions": 1, "radius": 1}}],
        "bodies": [{"name": "<script>", "model": "m"},
                   {"name": "a & 'b'", "model": "m", "position": [0.5, 0, 0]}]})");
    const std::string quoted = "'" + (folder / "it'\\''s <b>.json") + "'";
    const ProgramRun run = run_scb("inspect " + quoted + " --size 320x240 -o " + folder / "out");
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string html = html_in(folder / "out");
    EXPECT_EQ(html.find("<script"), std::string::npos);
    EXPECT_NE(html.find("&lt;script&gt;"), std::string::npos);
    EXPECT_NE(html.find("scb explain &apos;"), std::string::npos);
    EXPECT_NE(html.find("it&apos;\\&apos;&apos;s &lt;b&gt;.json&apos; --frames 0"),
              std::string::npos);
}

}  // namespace
}  // namespace scb::app
