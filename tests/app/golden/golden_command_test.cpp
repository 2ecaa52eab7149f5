#include "tests/app/golden/golden_command.h"

#include <nlohmann/json.hpp>

#include "app/golden/results.h"
#include "core/platform/output_file.h"
#include "render/files/image_file.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST_F(GoldenCommand, FindsNothingWhereNothingChanged) {
    const ProgramRun run = check();
    EXPECT_EQ(run.status, 0) << run.out << run.err;
    EXPECT_EQ(run.out, "5 cases: 5 same\n");
    for (const char* file : {"levels.counts.json", "levels.ids.png", "levels.png",
                             "levels.meta.json", "rejections.trace.scbrec", "collide.counts.json"})
        EXPECT_TRUE(fs::exists(baseline(file))) << file;
    for (const char* file : {"collide.png", "traversal.ids.png", "collide.trace.scbrec"})
        EXPECT_FALSE(fs::exists(baseline(file))) << file;
    // Counts are integers, and nothing depends on the machine's folders.
    EXPECT_EQ(file_text(baseline("levels.counts.json")).find('.'), std::string::npos);
    EXPECT_EQ(file_text(baseline("levels.meta.json")).find(folder.path.string()),
              std::string::npos);
    // A second update changes nothing.
    EXPECT_EQ(golden("update --all").out, "0 of 5 cases updated\n");
}

TEST_F(GoldenCommand, FindsOnePixelThatIsOffByOne) {
    render::Image image = render::read_png(baseline("rejections.png"));
    render::Rgba8 color = render::pixel(image, 123, 45);
    color.g = static_cast<std::uint8_t>(color.g ^ 1);
    render::set_pixel(image, 123, 45, color);
    write_file_whole(baseline("rejections.png"), render::encode_png(image));
    EXPECT_EQ(check().status, 1);
    const json found = result("rejections");
    EXPECT_EQ(found["verdict"], "different");
    EXPECT_EQ(found["colors"]["pixels"], 1);
    EXPECT_EQ(found["colors"]["largest"], 1);
    EXPECT_EQ(found["colors"]["box"], json::array({123, 45, 124, 46}));
    EXPECT_TRUE(found["ids"].is_null());
    EXPECT_TRUE(found["counts"].empty());
    EXPECT_EQ(result("levels")["verdict"], "same");
    for (const char* key : {"baseline", "candidate", "difference"})
        EXPECT_TRUE(fs::exists(report / found["picture"][key].get<std::string>())) << key;
    // Another accepted picture makes it pass; the traversal's picture is none of it.
    fs::copy_file(report / found["picture"]["candidate"].get<std::string>(),
                  baseline("rejections.2.png"));
    EXPECT_EQ(check().status, 0);
    // And so does a tolerance.
    fs::remove(baseline("rejections.2.png"));
    json tolerant = json::parse(golden_suite_text);
    tolerant["presets"]["small"]["tolerance"] = {{"max_channel_delta", 1}, {"max_pixels", 0}};
    write_text(suite, tolerant.dump());
    EXPECT_EQ(check().status, 0);
}

TEST_F(GoldenCommand, SaysWhichNodeAndWhichTestChanged) {
    // The suite now asks for another test than the baselines were made with.
    json other = json::parse(golden_suite_text);
    other["presets"]["small"]["test"] = "extents";
    other["cases"].erase(0);  // levels have no test
    write_text(suite, other.dump());
    const ProgramRun run = check("--trace");
    EXPECT_EQ(run.status, 1);
    const json found = result("rejections");
    EXPECT_EQ(found["verdict"], "different");
    std::string lines;
    for (const json& line : found["lines"]) lines += line.get<std::string>() + "\n";
    EXPECT_NE(lines.find("They part first at frame 100, test"), std::string::npos) << lines;
    EXPECT_NE(lines.find("Node "), std::string::npos) << lines;
    EXPECT_NE(lines.find(", level "), std::string::npos) << lines;
    bool stage = false, depth = false;
    for (const json& change : found["counts"]) {
        const std::string place = change["place"];
        stage |= place.find("stages/") != std::string::npos;
        depth |= place.find("n_v at depth/") != std::string::npos;
    }
    EXPECT_TRUE(stage);
    EXPECT_TRUE(depth);
    ASSERT_EQ(found["traces"].size(), 2u);
    const ProgramRun diff =
        run_scb("diff " + (report / found["traces"][0].get<std::string>()).string() + " " +
                (report / found["traces"][1].get<std::string>()).string());
    EXPECT_EQ(diff.status, 1);
    // The commands that it names do what they say.
    std::string reproduce = found["reproduce"].get<std::string>().substr(4);
    ASSERT_TRUE(reproduce.ends_with(" -o out"));
    reproduce.replace(reproduce.size() - 3, 3, folder / "made");
    EXPECT_EQ(run_scb(reproduce).status, 0);
    EXPECT_EQ(run_scb(found["update"].get<std::string>().substr(4)).status, 0);
    check();
    EXPECT_EQ(result("rejections")["verdict"], "same");
}

TEST_F(GoldenCommand, ToldApartAreMissingNewBrokenAndOfAnotherSize) {
    fs::remove(baseline("levels.counts.json"));
    fs::remove(baseline("levels.ids.png"));
    fs::remove(baseline("levels.png"));
    fs::remove(baseline("rejections.ids.png"));
    const std::string png = file_text(baseline("traversal.png"));
    write_text(baseline("traversal.png"), png.substr(0, png.size() / 2));
    write_text(baseline("collide.counts.json"), "{\"frames\": {");
    render::Image small;
    small.width = 160;
    small.height = 120;
    small.rgba.assign(4 * 160 * 120, 255);
    write_file_whole(baseline("inspect.png"), render::encode_png(small));
    const auto before = baselines();
    const ProgramRun run = check("--junit " + (folder / "junit.xml"));
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(result("levels")["verdict"], "missing baseline");
    EXPECT_TRUE(fs::exists(report / result("levels")["picture"]["candidate"].get<std::string>()));
    EXPECT_EQ(result("rejections")["verdict"], "new output");
    EXPECT_EQ(result("traversal")["verdict"], "could not run");
    EXPECT_NE(result("traversal")["message"].get<std::string>().find("traversal.png"),
              std::string::npos);
    EXPECT_EQ(result("collide")["verdict"], "could not run");
    EXPECT_NE(result("collide")["message"].get<std::string>().find("collide.counts.json"),
              std::string::npos);
    EXPECT_EQ(result("inspect")["verdict"], "size differs");
    EXPECT_NE(file_text(folder / "junit.xml").find("failures=\"3\""), std::string::npos);
    // A check changes no baseline.
    EXPECT_EQ(baselines(), before);
    // Updates: only what is missing; then everything, the broken ones by name.
    EXPECT_EQ(golden("update --missing").status, 0);
    EXPECT_TRUE(fs::exists(baseline("levels.png")));
    EXPECT_EQ(file_text(baseline("inspect.png")), before.at("inspect.png"));
    EXPECT_EQ(golden("update rejections traversal inspect collide").status, 0);
    EXPECT_EQ(check().status, 0);
}

TEST_F(GoldenCommand, GivesTheSameResultsHoweverItIsRun) {
    write_text(baseline("collide.counts.json"), "{}");
    const auto timeless = [this](const std::string& more) {
        check(more);
        for (json& entry : results["cases"]) entry.erase("seconds");
        return results;
    };
    const json once = timeless("--jobs 1");
    EXPECT_EQ(timeless("--jobs 2"), once);
    EXPECT_EQ(timeless("--jobs 16"), once);
    EXPECT_EQ(once["cases"].size(), 5u);
}

// What a run is given to, as an emulator would be, and stands for a machine that is not this one.
TEST_F(GoldenCommand, RunsWithWhatIsPutInFront) {
    const std::string runner = (folder.path / "runner").string();
    const auto run = [&](const std::string& script) {
        write_text(runner, "#!/bin/sh\n" + script);
        fs::permissions(runner, fs::perms::owner_all);
        return check("--runner " + runner);
    };
    EXPECT_EQ(run("echo lacks a feature >&2\nexec \"$@\"\n").status, 0);
    EXPECT_EQ(result("collide")["verdict"], "same");

    const std::string no_gl = "echo scb: error: No context. >&2; exit 77";
    const std::string pictures = "case \"$*\" in *--gl*) " + no_gl + ";; esac\n";
    EXPECT_EQ(run(pictures + "exec \"$@\"\n").status, 77);
    EXPECT_EQ(result("levels")["verdict"], "could not run");
    EXPECT_EQ(result("levels")["message"], "No context.");
    EXPECT_EQ(result("collide")["verdict"], "same");
    EXPECT_EQ(run(pictures + "exit 2\n").status, 1);
    EXPECT_EQ(
        run("case \"$*\" in *collide*) exec \"$@\" --test printed;; esac\nexec \"$@\"\n").status,
        1);
    EXPECT_EQ(result("collide")["verdict"], "different");
}

TEST_F(GoldenCommand, ShardsMakeOneReport) {
    write_text(baseline("collide.counts.json"), "{}");
    std::string from;
    for (int k = 1; k <= 3; ++k) {
        const std::string shard = folder / ("shard-" + std::to_string(k));
        golden("check --shard " + std::to_string(k) + "/3 --report " + shard);
        from += " " + shard + "/results.json";
    }
    const ProgramRun merged =
        run_scb("golden report --from" + from + " --report " + report.string());
    EXPECT_EQ(merged.status, 1) << merged.err;
    results = json::parse(file_text(report / "results.json"));
    EXPECT_EQ(results["cases"].size(), 5u);
    EXPECT_EQ(result("collide")["verdict"], "different");
    EXPECT_TRUE(fs::exists(report / "report.html"));
    const ProgramRun twice = run_scb("golden report --from" + from + from);
    EXPECT_EQ(twice.status, 2);
}

TEST_F(GoldenCommand, TellsGithubWhereThatListens) {
    write_text(baseline("collide.counts.json"), "{}");
    const std::string summary = folder / "summary.md";
    const ProgramRun run =
        golden("check", {"", {"GITHUB_ACTIONS=true", "GITHUB_STEP_SUMMARY=" + summary}});
    EXPECT_NE(run.out.find("::error title=collide"), std::string::npos) << run.out;
    EXPECT_NE(file_text(summary).find("collide"), std::string::npos);
}

TEST_F(GoldenCommand, RefusesWhatASuiteMustNotSay) {
    const auto refused = [&](const char* pointer, const json& value, const std::string& said) {
        json document = json::parse(golden_suite_text);
        document[json::json_pointer(pointer)] = value;
        write_text(suite, document.dump());
        const ProgramRun run = golden("check");
        EXPECT_EQ(run.status, 2) << pointer;
        EXPECT_NE(run.err.find(said), std::string::npos) << run.err;
    };
    refused("/cases/0/run", "draw", "levels, pairs, rejections");
    refused("/cases/0/preset", "large", "there is no preset large");
    refused("/cases/0/name", "../up", "letters, digits");
    refused("/cases/0/name", "collide", "there is a case collide");
    refused("/cases/0/size", "1024x768", "512x512");
    refused("/cases/0/arguments", json::array({"-o", "/tmp"}), "-o is not for cases");
    refused("/cases/0/compare", json::array({"looks"}), "counts, ids or colors");
    refused("/cases/4/compare", json::array({"colors"}), "collide draws none");
    refused("/cases/0/nonsense", 1, "nonsense");
    refused("/scb_golden", 3, "scb_golden");
    refused("/presets/small/preset", "small", "inherits itself");
}

TEST(GoldenResults, HaveAtMost25LinesForACase) {
    golden::SuiteResult result;
    golden::CaseResult& failed = result.cases.emplace_back();
    failed.name = "levels";
    failed.verdict = golden::Verdict::different;
    failed.reproduce = "scb render levels";
    failed.lines.assign(23, "a line");
    EXPECT_EQ(lines_of(results_text(result, "all.html")), 26u);  // and the sum
    EXPECT_EQ(results_text(result, "all.html").find("all.html"), std::string::npos);
    failed.lines.assign(40, "a line");
    const std::string text = results_text(result, "all.html");
    EXPECT_EQ(lines_of(text), 26u);
    EXPECT_NE(text.find("    scb render levels\n    18 more lines are in all.html.\n1 case"),
              std::string::npos)
        << text;
}

}  // namespace
}  // namespace scb::app
