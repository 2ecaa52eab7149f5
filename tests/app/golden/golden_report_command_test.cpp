#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "core/platform/output_file.h"
#include "render/files/image_file.h"
#include "tests/app/program.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* suite_text = R"({
  "scb_golden": 1,
  "presets": {"small": {"size": "320x240", "scene": "cone", "frames": "100"}},
  "cases": [
    {"name": "levels", "preset": "small", "run": "levels", "arguments": ["--levels", "4"]},
    {"name": "rejections", "preset": "small", "run": "rejections"},
    {"name": "collide", "run": "collide", "scene": "cone", "frames": "0:100:50"},
    {"name": "single", "run": "collide", "scene": "cone", "frames": "100"}
  ]
})";

/// A suite in a folder with a space, whose baselines have another name than is usual.
class GoldenReport : public testing::Test {
  protected:
    GoldenReport() {
        fs::create_directory(home);
        write_text(home / "cases.json", suite_text);
        EXPECT_EQ(golden("update --all").status, 0);
    }

    /// Runs from where the suite is, as a user would.
    ProgramRun run(const std::string& arguments,
                   const std::vector<std::string>& environment = {}) const {
        return run_scb(arguments, {home.string(), environment});
    }
    ProgramRun golden(const std::string& arguments,
                      const std::vector<std::string>& environment = {}) const {
        return run("golden " + arguments + where, environment);
    }
    ProgramRun check(const std::string& more = "",
                     const std::vector<std::string>& environment = {}) {
        const ProgramRun ended = golden("check --report out " + more, environment);
        results = json();
        if (fs::exists(home / "out/results.json"))
            results = json::parse(file_text(home / "out/results.json"));
        page = file_text(home / "out/report.html");
        return ended;
    }
    json result(const std::string& name) const {
        for (const json& entry : results["cases"])
            if (entry["name"] == name) return entry;
        return {};
    }
    fs::path baseline(const std::string& file) const { return home / "accepted" / file; }
    void break_counts(const std::string& name) const {
        const fs::path file = baseline(name + ".counts.json");
        write_text(file,
                   std::regex_replace(file_text(file), std::regex("\"n_v\": "), "\"n_v\": 1"));
    }

    /// Writes the suite with another value, and without the cases that are named.
    void change_suite(const std::string& pointer, const json& value,
                      const std::vector<std::string>& without) const {
        json suite = json::parse(suite_text);
        suite[json::json_pointer(pointer)] = value;
        json cases = json::array();
        for (const json& entry : suite["cases"])
            if (std::find(without.begin(), without.end(), entry["name"]) == without.end())
                cases.push_back(entry);
        suite["cases"] = cases;
        write_text(home / "cases.json", suite.dump());
    }

    const TemporaryFolder folder;
    const fs::path home = folder.path / "my suite";
    const std::string where = " --suite cases.json --baselines accepted";
    json results;
    std::string page;
};

std::string without_entities(std::string text) {
    for (const auto& [entity, character] : {std::pair("&quot;", "\""), std::pair("&#39;", "'"),
                                            std::pair("&gt;", ">"), std::pair("&amp;", "&")})
        text = std::regex_replace(text, std::regex(entity), character);
    return text;
}

/// The values of an attribute, in the order of the page.
std::vector<std::string> values_of(const std::string& page, const std::string& attribute) {
    std::vector<std::string> values;
    const std::regex pattern(attribute + "=\"([^\"]*)\"");
    for (std::sregex_iterator i(page.begin(), page.end(), pattern), end; i != end; ++i)
        values.push_back(without_entities((*i)[1]));
    return values;
}

TEST_F(GoldenReport, TickedCasesAreUpdatedWhereTheyWereChecked) {
    break_counts("collide");
    break_counts("single");
    ASSERT_EQ(check().status, 1);
    const std::vector<std::string> prefixes = values_of(page, "data-prefix");
    ASSERT_EQ(prefixes.size(), 2u) << page.substr(page.find("<main>"));
    EXPECT_EQ(prefixes[0], "scb golden update" + where);
    EXPECT_EQ(prefixes[1], prefixes[0]);
    // One command of both names, as the page's script puts it together.
    EXPECT_EQ(run(prefixes[0].substr(4) + " collide single").status, 0);
    EXPECT_EQ(check().status, 0);
}

TEST_F(GoldenReport, CommandsHaveTheOptionsOfTheCheck) {
    break_counts("collide");
    break_counts("single");
    fs::remove(baseline("levels.png"));
    const std::string runner = folder / "runner";
    write_text(runner, "#!/bin/sh\nshift\nexec \"$@\"\n");
    fs::permissions(runner, fs::perms::owner_all);
    check("--models . --runner '" + runner + " -x'");
    const std::string update = result("collide")["update"];
    EXPECT_EQ(update,
              "scb golden update" + where + " --models . --runner '" + runner + " -x' collide");
    EXPECT_EQ(
        result("collide")["reproduce"],
        runner + " -x \"$(command -v scb)\" collide cone --frames 0:100:50 --json --models .");
    EXPECT_EQ(run(update.substr(4)).status, 0);
    // What the environment says, it says to every command.
    check("", {"SCB_MODELS=."});
    EXPECT_EQ(result("single")["reproduce"], "scb collide cone --frames 100 --json");
    EXPECT_EQ(result("single")["update"], "scb golden update" + where + " single");
    check("--gl egl");
    EXPECT_TRUE(result("levels")["reproduce"].get<std::string>().ends_with(" --gl egl"));
    EXPECT_EQ(result("single")["reproduce"], "scb collide cone --frames 100 --json");
}

TEST_F(GoldenReport, OneReportNeedsEveryShard) {
    const auto shard = [&](const std::string& which) {
        const std::string out = "shard-" + which.substr(0, 1);
        EXPECT_EQ(golden("check --shard " + which + " --report " + out).status, 0);
        return out + "/results.json ";
    };
    const std::string first = shard("1/2"), second = shard("2/2");
    const ProgramRun half = run("golden report --report out --from " + second);
    EXPECT_EQ(half.status, 1) << half.out;
    EXPECT_NE(half.out.find("These shards are missing: 1/2"), std::string::npos) << half.out;
    page = file_text(home / "out/report.html");
    EXPECT_NE(page.find("These shards are missing: 1/2"), std::string::npos);
    const ProgramRun whole = run("golden report --report out --from " + second + first);
    EXPECT_EQ(whole.status, 0) << whole.out;
    std::string names;
    results = json::parse(file_text(home / "out/results.json"));
    for (const json& entry : results["cases"]) names += entry["name"].get<std::string>() + " ";
    EXPECT_EQ(names, "levels rejections collide single ");
    // A run without shards is complete.
    EXPECT_EQ(check().status, 0);
    EXPECT_EQ(run("golden report --report all --from out/results.json").status, 0);
}

TEST_F(GoldenReport, NoCasesAreNoSuccess) {
    const ProgramRun none = golden("check --shard 5/5 --report shard-5");
    EXPECT_EQ(none.status, 0);
    EXPECT_EQ(none.out, "0 cases; none are left for shard 5/5\n");
    write_text(home / "cases.json", R"({"scb_golden": 1, "cases": []})");
    const ProgramRun empty = check();
    EXPECT_EQ(empty.status, 2);
    EXPECT_NE(empty.err.find("there is no case to check"), std::string::npos) << empty.err;
    EXPECT_EQ(golden("check --shard 1/1 --report out").status, 2);
    json nothing = json::parse(file_text(home / "shard-5/results.json"));
    nothing["shard"] = "1/1";
    write_text(home / "empty.json", nothing.dump());
    EXPECT_EQ(run("golden report --from empty.json").status, 1);
}

TEST_F(GoldenReport, RemovesOnlyWhatAnEarlierReportListed) {
    fs::create_directory(home / "out");
    write_text(home / "out/photo.new.png", "mine");
    write_text(home / "out/thesis.difference.png", "mine");
    fs::remove(baseline("levels.png"));
    check();
    const fs::path picture = home / "out/levels.new.png";
    EXPECT_TRUE(fs::exists(picture));
    golden("update levels");
    EXPECT_EQ(check().status, 0);
    EXPECT_FALSE(fs::exists(picture));
    EXPECT_EQ(file_text(home / "out/photo.new.png"), "mine");
    EXPECT_EQ(file_text(home / "out/thesis.difference.png"), "mine");
    // A file of that name that is none of ours says nothing, and is not replaced.
    const std::string foreign = R"({"cases": [{"traces": ["photo.new.png"]}]})";
    write_text(home / "out/results.json", foreign);
    EXPECT_EQ(check().status, 2);
    EXPECT_EQ(file_text(home / "out/results.json"), foreign);
    write_text(home / "out/results.json",
               R"({"suite": "", "cases": [{"traces": ["../photo.png"]}]})");
    write_text(home / "photo.png", "mine");
    EXPECT_EQ(check().status, 0);
    EXPECT_EQ(file_text(home / "photo.png"), "mine");
    EXPECT_EQ(file_text(home / "out/photo.new.png"), "mine");
}

TEST_F(GoldenReport, WritesTextThatIsNoUtf8) {
    const std::string runner = folder / "runner";
    write_text(runner, "#!/bin/sh\nprintf 'scb: error: a \\377 byte.\\n' >&2\nexit 2\n");
    fs::permissions(runner, fs::perms::owner_all);
    const ProgramRun ended = check("--json all.json --junit junit.xml --runner " + runner);
    EXPECT_EQ(ended.status, 1) << ended.err;
    EXPECT_NE(ended.out.find("a ? byte."), std::string::npos) << ended.out;
    EXPECT_EQ(result("collide")["message"], "a \ufffd byte.");
    EXPECT_EQ(json::parse(file_text(home / "all.json")), results);
    EXPECT_NE(file_text(home / "junit.xml").find("a \ufffd byte."), std::string::npos);
    EXPECT_EQ(run("golden report --from out/results.json").status, 1);
}

TEST_F(GoldenReport, SaysTheResultWhereItCannotBeWritten) {
    break_counts("collide");
    write_text(home / "file", "");
    for (const char* command : {"check", "report --from out/results.json"}) {
        const bool is_check = std::string(command) == "check";
        if (!is_check) check();
        const std::string words = std::string("golden ") + command + (is_check ? where : "");
        const ProgramRun ended = run(words + " --report file/out --junit junit.xml");
        EXPECT_EQ(ended.status, 3) << command;
        EXPECT_NE(ended.out.find("collide: different."), std::string::npos) << ended.out;
        EXPECT_NE(ended.err.find("file/out"), std::string::npos) << ended.err;
        // What can be written is.
        EXPECT_NE(file_text(home / "junit.xml").find("collide"), std::string::npos);
        fs::remove(home / "junit.xml");
    }
}

TEST_F(GoldenReport, TracesAreKeptOnlyInAReport) {
    const ProgramRun refused = golden("check --trace");
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("--report DIR"), std::string::npos) << refused.err;
}

TEST_F(GoldenReport, TracesAreCalledWhatTheyAre) {
    change_suite("/presets/small/test", "extents", {"levels"});
    const ProgramRun ended = check("--trace --junit junit.xml", {"GITHUB_STEP_SUMMARY=summary.md"});
    EXPECT_EQ(ended.status, 1);
    const json found = result("rejections");
    const std::string text = found["trace_difference"];
    for (const std::string& said :
         {ended.out, page, file_text(home / "junit.xml"), file_text(home / "summary.md"), text}) {
        EXPECT_EQ(said.find("scb-golden-"), std::string::npos) << said.substr(0, 4000);
        EXPECT_EQ(said.find("the first tested"), std::string::npos);
        EXPECT_NE(said.find("the baseline tested"), std::string::npos) << said.substr(0, 4000);
        EXPECT_NE(said.find("the new run tested"), std::string::npos);
    }
    // What it comes to is said first, and the whole keeps its columns.
    EXPECT_EQ(found["cause"], "The overlap test changed: extents instead of symmetric.");
    EXPECT_TRUE(found["lines"][0].get<std::string>().starts_with("They part first at frame 100"))
        << found["lines"];
    EXPECT_NE(text.find("baseline      new run new run - baseline\n"), std::string::npos) << text;
    EXPECT_NE(page.find("<pre class=\"trace\""), std::string::npos);
    // A page beside it begins where they part.
    const std::string view = found["view"];
    EXPECT_TRUE(view.starts_with("rejections.view.html#frame=100&nodes=")) << view;
    EXPECT_NE(page.find("rejections.view.html"), std::string::npos);
    EXPECT_NE(file_text(home / "out/rejections.view.html").find("\"scb_view\":1"),
              std::string::npos);
    // The command works from the folder of the check. So does the command in a report of reports.
    EXPECT_EQ(found["diff"], "scb diff out/rejections.baseline.scbrec out/rejections.new.scbrec");
    EXPECT_EQ(run(found["diff"].get<std::string>().substr(4)).status, 1);
    EXPECT_EQ(run("golden report --from out/results.json --report all").status, 1);
    results = json::parse(file_text(home / "all/results.json"));
    EXPECT_EQ(run(result("rejections")["diff"].get<std::string>().substr(4)).status, 1);
    EXPECT_TRUE(fs::exists(home / "all/rejections.view.html"));
}

TEST_F(GoldenReport, TracesSayWhatOlderBaselinesDoNot) {
    const fs::path meta = baseline("rejections.meta.json");
    json record = json::parse(file_text(meta));
    record.erase("settings");
    record.erase("poses");
    write_text(meta, record.dump());
    change_suite("/presets/small/test", "extents", {"levels"});
    check();
    EXPECT_EQ(result("rejections")["cause"], "");
    EXPECT_EQ(result("rejections")["lines"][0], "Another test: symmetric before, extents now.");
}

TEST_F(GoldenReport, CountsHaveTheirValuesAndOneTotalEverywhere) {
    change_suite("/presets/small/test", "extents", {"levels"});
    const ProgramRun ended = check("--junit junit.xml", {"GITHUB_STEP_SUMMARY=summary.md"});
    const json found = result("rejections");
    std::size_t counts = 0, depths = 0;
    std::string line;
    for (const json& change : found["counts"]) {
        const bool depth = change["place"].get<std::string>().find("at depth") != std::string::npos;
        ++(depth ? depths : counts);
        if (change["place"] == "frames/100/n_v") line = "frames/100/n_v: ";
    }
    ASSERT_GT(counts, 1u);
    ASSERT_GT(depths, 0u);
    ASSERT_FALSE(line.empty());
    const std::string total = std::to_string(counts) + " counts";
    EXPECT_NE(found["message"].get<std::string>().find(total), std::string::npos);
    EXPECT_NE(page.find("<h3>" + total + " differ</h3>"), std::string::npos);
    for (const std::string& said : {ended.out, without_entities(file_text(home / "junit.xml")),
                                    file_text(home / "summary.md")}) {
        EXPECT_TRUE(
            std::regex_search(said, std::regex(line + "[0-9,]+ -> [0-9,]+ \\([+-][0-9,]+\\)")))
            << said;
        EXPECT_EQ(said.find("at depth/"), std::string::npos);
    }
}

TEST_F(GoldenReport, ThingsAreNamedAlikeAndSayWhatMoved) {
    change_suite("/presets/small/test", "extents", {"levels"});
    check();
    const json found = result("rejections");
    ASSERT_FALSE(found["ids"]["changes"].empty());
    const std::string owner = found["owners"][0], id = found["ids"]["changes"][0]["id"].dump();
    EXPECT_TRUE(std::regex_match(owner, std::regex("(node [0-9]+ of .*, level [0-9]+|.*)")));
    const std::string lines = found["lines"].dump();
    EXPECT_NE(lines.find(owner.substr(1) + " (id " + id + ")"), std::string::npos) << lines;
    EXPECT_NE(page.find(id + " <span class=\"faint\">" + owner), std::string::npos);
    EXPECT_FALSE(std::regex_search(lines, std::regex("had ([0-9,]+) pixels? and has \\1\\.")))
        << lines;
}

TEST_F(GoldenReport, AnotherMeshIsNamedFirstAndHasNoLevels) {
    change_suite("/presets/small/scene", "soup", {"levels"});
    check();
    const json lines = result("rejections")["lines"];
    ASSERT_GE(lines.size(), 2u);
    const std::string cause = result("rejections")["cause"];
    EXPECT_EQ(cause,
              "The scene changed: soup instead of cone. The meshes of bodies A and B changed: "
              "2,000 triangles instead of 2,304.");
    EXPECT_EQ(lines.dump().find("Another "), std::string::npos) << lines;
    EXPECT_EQ(lines.dump().find(", level "), std::string::npos) << lines;
}

TEST_F(GoldenReport, ShowsWhatIsNew) {
    fs::remove(baseline("levels.png"));           // new output
    fs::remove(baseline("rejections.ids.png"));   // the same, of ids
    fs::remove(baseline("collide.counts.json"));  // all of it
    check();
    EXPECT_EQ(result("levels")["verdict"], "new output");
    EXPECT_EQ(result("levels")["picture"]["candidate"], "levels.new.png");
    EXPECT_TRUE(fs::exists(home / "out/levels.new.png"));
    EXPECT_TRUE(result("levels")["counts"].empty());
    EXPECT_EQ(result("rejections")["id_picture"]["candidate"], "rejections.new.ids.png");
    EXPECT_TRUE(fs::exists(home / "out/rejections.new.ids.png"));
    EXPECT_EQ(result("collide")["verdict"], "missing baseline");
    EXPECT_FALSE(result("collide")["counts"].empty());
    EXPECT_TRUE(result("collide")["counts"][0]["before"].is_null());
    EXPECT_NE(page.find(" counts are new</h3>"), std::string::npos);
}

TEST_F(GoldenReport, SaysWhatToDoAboutABaselineThatCannotBeRead) {
    const std::string png = file_text(baseline("levels.png"));
    write_text(baseline("levels.png"), png.substr(0, png.size() / 2));
    const ProgramRun ended = check();
    EXPECT_EQ(result("levels")["verdict"], "could not run");
    EXPECT_NE(ended.out.find("Restore it from version control"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("scb golden update" + where + " levels\n"), std::string::npos);
    EXPECT_EQ(result("levels")["picture"]["candidate"], "levels.new.png");
    // A case that did not run has nothing to take over.
    change_suite("/cases/2/scene", "missing.json", {});
    write_text(baseline("levels.png"), png);
    check();
    EXPECT_EQ(result("collide")["verdict"], "could not run");
    EXPECT_EQ(result("collide")["update"], "");
}

TEST_F(GoldenReport, SaysWhatPassesOnlyWithinATolerance) {
    render::Image image = render::read_png(baseline("levels.png"));
    render::Rgba8 color = render::pixel(image, 12, 34);
    color.g = static_cast<std::uint8_t>(color.g ^ 1);
    render::set_pixel(image, 12, 34, color);
    write_file_whole(baseline("levels.png"), render::encode_png(image));
    change_suite("/presets/small/tolerance", {{"max_channel_delta", 1}, {"max_pixels", 0}}, {});
    const ProgramRun ended = check();
    EXPECT_EQ(ended.status, 0);
    EXPECT_EQ(ended.out, "4 cases: 4 same (1 within the tolerance)\n");
    EXPECT_EQ(result("levels")["colors"]["pixels"], 1);
    EXPECT_TRUE(result("rejections")["colors"].is_null());
    EXPECT_NE(page.find("within its tolerance: 1 pixel differs, by up to 1 of 255"),
              std::string::npos);
}

}  // namespace
}  // namespace scb::app
