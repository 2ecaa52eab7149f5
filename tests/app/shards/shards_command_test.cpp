#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/cli/commands.h"
#include "app/reference/command_reference.h"
#include "core/base/text_format.h"
#include "tests/app/program.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

/// Files by their paths in the folder, except files of shards.
std::map<std::string, std::string> files_of(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = fs::relative(entry.path(), folder).string();
        if (entry.is_regular_file() && !name.starts_with("shards/"))
            files[name] = file_text(entry.path());
    }
    return files;
}

/// The names of files that differ, or are in one folder alone.
std::vector<std::string> differing(const fs::path& folder, const fs::path& other) {
    const auto files = files_of(folder), others = files_of(other);
    std::vector<std::string> names;
    for (const auto& [name, text] : files)
        if (!others.contains(name) || others.at(name) != text) names.push_back(name);
    for (const auto& [name, text] : others)
        if (!files.contains(name)) names.push_back(name);
    return names;
}

struct Shards : testing::Test {
    TemporaryFolder folder;
    std::string whole = folder / "whole", parts = folder / "parts", merged = folder / "merged";

    ProgramRun shard(const std::string& arguments, int k, int n, const std::string& out) const {
        return run_scb("--quiet " + arguments + " --shard " + std::to_string(k) + "/" +
                       std::to_string(n) + " -o " + out);
    }
    void make_shards(const std::string& arguments, int n) const {
        for (int k = 1; k <= n; ++k) {
            const ProgramRun run = shard(arguments, k, n, parts);
            EXPECT_EQ(run.status, 0) << arguments << run.err;
            EXPECT_TRUE(run.out.ends_with("/shards/" + std::to_string(k) + "-of-" +
                                          std::to_string(n) + ".json\n"))
                << run.out;
        }
    }
    /// Joined in a folder of its own, and where the shards are.
    void expect_the_same(const std::string& arguments, int n) const {
        SCOPED_TRACE(arguments);
        for (const std::string& made : {whole, parts, merged}) fs::remove_all(made);
        const ProgramRun one = run_scb("--quiet " + arguments + " -o " + whole);
        make_shards(arguments, n);
        const ProgramRun joined = run_scb("--quiet merge " + parts + " -o " + merged);
        EXPECT_EQ(joined.status, one.status) << joined.err;
        EXPECT_EQ(joined.err, one.err);
        EXPECT_EQ(differing(whole, merged), std::vector<std::string>{});
        EXPECT_EQ(run_scb("--quiet merge " + parts + " -o " + parts).status, one.status);
        EXPECT_EQ(differing(whole, parts), std::vector<std::string>{});
    }
};

const std::string small_pictures = " --size 320x240";

TEST_F(Shards, OfPicturesGiveTheBytesOfOneRun) {
    for (const char* arguments : {
             "render rejections spheres-l1 --frames 0:499:100 --sheet",
             "render pairs knots-l1 --frames 0,40,80 --compare scb,ball --sheet --ids",
             "render rejections spheres-l1 --frames 0:60:15 --compare scb,obb --sheet",
             "render pairs spheres-l1 --frames 150:250:50 --heat volumes --sheet --svg",
             "render traversal spheres-l1 --frames 100,200,300 --by share",
             "render levels knots-l1 --volume scb,obb --levels 0:4 --ids",
         })
        expect_the_same(arguments + small_pictures, 2);
    // More shards than frames, so that some have none; and each step of an animation is a part.
    expect_the_same("render pairs spheres-l1 --frames 100 --no-panel" + small_pictures, 3);
    expect_the_same("render rejections knots-l1 --frames 0 --steps 4000 --sheet" + small_pictures,
                    2);
}

TEST_F(Shards, OfAnAnimationAreJoinedToOne) {
    const std::string video = folder / "v.webp", other = folder / "other.webp";
    const std::string arguments =
        "render pairs spheres-l1 --frames 100,150,200 --video " + video + small_pictures;
    EXPECT_EQ(run_scb("--quiet " + arguments + " -o " + whole).status, 0);
    fs::rename(video, other);
    make_shards(arguments, 2);
    EXPECT_FALSE(fs::exists(video));
    EXPECT_NE(run_scb(arguments + " --shard 1/2 -o " + parts)
                  .err.find("--video: a shard has no video; give the option to `scb merge`."),
              std::string::npos);
    // A shard does not say where anything is written.
    EXPECT_EQ(run_scb("--quiet merge " + parts + " -o " + merged).status, 0);
    EXPECT_FALSE(fs::exists(video));
    EXPECT_EQ(run_scb("--quiet merge " + parts + " -o " + merged + " --video " + video).status, 0);
    EXPECT_EQ(file_text(video), file_text(other));
    EXPECT_EQ(differing(whole, merged), std::vector<std::string>{});
}

TEST_F(Shards, OfInspectGiveTheReportOfOneRun) {
    expect_the_same("inspect spheres-l1 --frames 0:499:125 --top 2 --no-view" + small_pictures, 3);
    // Its test misses pairs, which is the exit status of the whole.
    expect_the_same(
        "inspect spheres-l1 --frames 150,200,250 --test printed --top 3 --no-view" + small_pictures,
        2);
    const std::string tables = "inspect knots-l1 --frames 0,50 --level 6";
    fs::remove_all(parts);
    make_shards(tables, 2);
    EXPECT_EQ(run_scb("--quiet merge " + parts).out, run_scb("--quiet " + tables).out);
}

TEST_F(Shards, OfBenchGiveItsCounts) {
    const std::string arguments =
        "bench spheres-l1 knots-l1 --frames 0:499:200 --volume scb,obb --repeat 1 --measures";
    EXPECT_EQ(run_scb("--quiet " + arguments + " -o " + whole).status, 0);
    make_shards(arguments, 2);
    EXPECT_EQ(run_scb("--quiet merge " + parts + " -o " + merged).status, 0);
    const auto without_times = [](json bench) {
        bench.erase("equation_1");
        bench.erase("correlation");
        for (json& scene : bench["scenes"])
            for (json& row : scene["hierarchies"])
                for (const char* time : {"ms", "ns_per_volume_test", "time_over_scb"})
                    row.erase(time);
        return bench;
    };
    const auto table = [](const std::string& file) { return json::parse(file_text(file)); };
    EXPECT_EQ(without_times(table(merged + "/bench.json")),
              without_times(table(whole + "/bench.json")));
    const std::vector<std::string> rows = lines(file_text(merged + "/bench.csv")),
                                   others = lines(file_text(whole + "/bench.csv"));
    ASSERT_EQ(rows.size(), others.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto counts = [](const std::string& row) {
            std::vector<std::string> cells;
            std::string cell;
            for (std::istringstream in(row); std::getline(in, cell, ',');) cells.push_back(cell);
            if (cells.size() > 4) cells[4].clear();
            return cells;
        };
        EXPECT_EQ(counts(rows[i]), counts(others[i]));
    }
}

struct BadShards : Shards {
    const std::string arguments = "render pairs spheres-l1 --frames 100,200" + small_pictures;

    void expect_refused(const std::string& line, const std::string& words, int status = 2) const {
        const ProgramRun run = run_scb("--quiet " + line);
        EXPECT_EQ(run.status, status) << line;
        EXPECT_NE(run.err.find(words), std::string::npos) << line << "\n" << run.err;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        EXPECT_FALSE(fs::exists(merged + "/index.json")) << line;
    }
    void change(const std::string& file, const std::function<void(json&)>& change) const {
        json shard = json::parse(file_text(parts + "/shards/" + file));
        change(shard);
        write_text(parts + "/shards/" + file, shard.dump());
    }
};

TEST_F(BadShards, OnesThatAreMissingAreNamedWithTheirCommand) {
    EXPECT_EQ(shard(arguments, 1, 2, parts).status, 0);
    expect_refused("merge " + parts + " -o " + merged,
                   "shard 2/2 is missing; make it: scb render pairs spheres-l1 --frames=100,200");
    expect_refused("merge " + (folder / "none") + " -o " + merged, "there is no such file");
    fs::create_directories(folder / "empty");
    expect_refused("merge " + (folder / "empty") + " -o " + merged, "no shard is in this folder");
}

TEST_F(BadShards, OfOtherRunsAreRefused) {
    make_shards(arguments, 2);
    const std::string one = parts + "/shards/1-of-2.json";
    expect_refused("merge " + one + " " + one + " -o " + merged, "shard 1/2 is in ");
    const std::string others = folder / "others";
    EXPECT_EQ(shard(arguments + " --volume obb", 2, 2, others).status, 0);
    expect_refused("merge " + one + " " + others + " -o " + merged, "are of different runs");
    EXPECT_EQ(shard(arguments, 2, 3, others).status, 0);
    expect_refused("merge " + one + " " + others + "/shards/2-of-3.json -o " + merged,
                   "name those of one division");
    expect_refused("render rejections spheres-l1 --frames 100,200 --shard 1/2 -o " + parts,
                   "is the shard of another run");
    change("1-of-2.json", [](json& shard) { shard["versions"]["mesa"] = "1.2.3"; });
    expect_refused("merge " + parts + " -o " + merged, "made by different versions");
    change("2-of-2.json", [](json& shard) { shard["versions"]["mesa"] = "1.2.3"; });
    expect_refused("merge " + parts + " -o " + merged, "merge where it was made");
}

TEST_F(BadShards, DamagedOnesAreRefused) {
    make_shards(arguments, 2);
    const std::string file = parts + "/shards/1-of-2.json", good = file_text(file);
    const auto first_picture = [](json& shard) -> json& {
        return shard["parts"][0]["made"]["pictures"][0]["entry"];
    };
    const auto refused = [&](const std::function<void(json&)>& how, const std::string& words) {
        write_text(file, good);
        change("1-of-2.json", how);
        expect_refused("merge " + parts + " -o " + merged, words);
    };
    refused([](json& shard) { shard["parts"].clear(); }, "part 0 is missing");
    refused([](json& shard) { shard["parts"][0]["number"] = 1; }, "part 1 is not of this shard");
    refused([](json& shard) { shard.erase("command"); }, "this is no file of a shard");
    refused([](json& shard) { shard["parts"][0]["made"] = 3; }, "part 0 is damaged");
    refused([&](json& shard) { first_picture(shard)["file"] = "../../stolen.png"; },
            "a picture has the name of a file alone");
    refused([&](json& shard) { first_picture(shard)["file"] = "notes.txt"; },
            "a picture has the name of a file alone, .png at its end");
    refused([&](json& shard) { first_picture(shard)["file"] = "gone.png"; }, "gone.png");
    refused([](json& shard) { shard["files"].begin().value() = "00000000"; },
            "the file is not as shard 1/2 made it; make this shard again: scb render pairs");
    refused([](json& shard) { shard = {{"cases", json::array()}}; }, "scb golden report");
    refused(
        [](json& shard) {
            shard["command"] = {"golden", "update"};
        },
        "no command that can be shared made it");
    for (const std::size_t bytes : {std::size_t{0}, good.size() / 2, good.size() - 3}) {
        write_text(file, good.substr(0, bytes));
        expect_refused("merge " + parts + " -o " + merged, "not valid JSON");
    }
}

// A shard may be a stranger's: it says what is drawn, not where anything is written or what is run.
TEST_F(BadShards, WithOptionsThatWriteAreRefused) {
    make_shards(arguments, 2);
    const std::string file = parts + "/shards/1-of-2.json", other = parts + "/shards/2-of-2.json",
                      good = file_text(file), other_good = file_text(other),
                      stolen = folder / "stolen.webp";
    for (const std::string& word :
         {"--video=" + stolen, "--output=" + (folder / "other"), "-o" + (folder / "other"),
          std::string("-o"), std::string("--fps=3"), std::string("--open"),
          std::string("--terminal"), std::string("--shard=1/2"), "--merged=" + file,
          std::string("--jobs=1"), std::string("--help"), std::string("--watch"),
          std::string("--version"), std::string("--size"), std::string("--new-option=x"),
          std::string("--"), "--pairs-out=" + stolen, std::string("--vid")}) {
        write_text(file, good);
        write_text(other, other_good);
        for (const char* name : {"1-of-2.json", "2-of-2.json"})
            change(name, [&](json& shard) { shard["command"].push_back(word); });
        expect_refused("merge " + parts + " -o " + merged,
                       "1-of-2.json: its command has '" + word.substr(0, 40) +
                           "', which no shard of `scb render pairs` leaves to `scb merge`");
    }
    EXPECT_FALSE(fs::exists(stolen));
    EXPECT_FALSE(fs::exists(folder / "other"));
    // A long word is quoted in part.
    for (const std::string& word : {std::string(3000, 'x'), "--size=" + std::string(3000, 'x')}) {
        write_text(file, good);
        change("1-of-2.json", [&](json& shard) { shard["command"].push_back(word); });
        const ProgramRun run = run_scb("--quiet merge " + parts + " -o " + merged);
        EXPECT_EQ(run.status, 2);
        EXPECT_LT(run.err.size(), 2000u) << run.err;
    }
}

// An option that nobody has marked is refused by the merge: each is of a known kind.
TEST(ShardOptions, AreShareableOrSaidToTheMerge) {
    CLI::App app;
    OptionTable table;
    Console console;
    Action action;
    const Command program(app, table);
    const Command render = program.add_subcommand("render", "");
    add_render_levels(render, console, action);
    add_render_pairs(render, console, action);
    add_render_rejections(render, console, action);
    add_render_traversal(render, console, action);
    add_inspect(program, console, action);
    add_bench(program, console, action);
    const std::set<std::string> said_to_merge = {"--help", "--output",   "--open",
                                                 "--jobs", "--terminal", "--video",
                                                 "--fps",  "--shard",    "--coherent"};
    const ReferenceCommand reference = reference_of_program(program);
    std::size_t shareable = 0;
    for (const ReferenceCommand* command : all_commands(reference)) {
        if (!command->commands.empty()) continue;
        for (const ReferenceOption& option : command->options) {
            const bool is_said =
                std::any_of(option.names.begin(), option.names.end(),
                            [&](const std::string& name) { return said_to_merge.contains(name); });
            EXPECT_NE(option.is_shareable, is_said) << command->name << option.names.back();
            EXPECT_FALSE(option.is_shareable && option.is_only_typed && !option.takes_several)
                << command->name << option.names.back();
            shareable += option.is_shareable;
        }
    }
    EXPECT_GT(shareable, 100u);
}

// A view for the sheet of another size would be copied beyond its cell.
TEST_F(BadShards, PicturesThatWereChangedAreRefused) {
    make_shards(arguments + " --sheet", 2);
    for (const fs::directory_entry& entry : fs::directory_iterator(parts))
        if (entry.is_regular_file())
            write_text(parts + "/shards/" + entry.path().filename().string(),
                       file_text(entry.path()));
    expect_refused("merge " + parts + " -o " + merged, "the file is not as shard 1/2 made it");
    // Also if the recorded hashes were changed with the files.
    for (const char* name : {"1-of-2.json", "2-of-2.json"})
        change(name, [&](json& shard) {
            for (auto& [file, hash] : shard["files"].items())
                hash = short_hash(file_text(parts + "/" + file));
        });
    expect_refused("merge " + parts + " -o " + merged, "of another size than the shard's");
    expect_refused("merge " + parts + " -o " + parts + "/shards", "this folder keeps the shards");
}

TEST_F(BadShards, OfASceneThatHasChangedAreRefused) {
    const std::string scene = folder / "scene.json", before = endless_scene;
    std::string after = before;
    after.replace(after.find("1.98"), 4, "1.97");
    for (const std::string command : {"render pairs ", "inspect ", "bench --repeat 1 "}) {
        const std::string asked = command + scene + " --frames 0,1,2";
        fs::remove_all(parts);
        write_text(scene, before);
        EXPECT_EQ(shard(asked, 1, 2, parts).status, 0);
        write_text(scene, after);
        EXPECT_EQ(shard(asked, 2, 2, parts).status, 0);
        expect_refused("merge " + parts + " -o " + merged, "of different scenes");
        EXPECT_EQ(shard(asked, 1, 2, parts).status, 0);
        write_text(scene, before);
        expect_refused("merge " + parts + " -o " + merged, "the scene has changed since");
    }
}

TEST_F(BadShards, NumbersOfAnotherQueryAreRefused) {
    const std::string inspect = "inspect spheres-l1 --frames 100,200";
    make_shards(inspect, 2);
    const std::string file = parts + "/shards/1-of-2.json", good = file_text(file);
    for (const char* place :
         {"/worst/0/outermost/0/test/nodes/a", "/worst/0/outermost/0/test/stage",
          "/worst/0/outermost/0/pair/exact", "/worst/0/outermost/0/pair/reason",
          "/worst/0/outermost/0/frame", "/frames/0/frame"}) {
        write_text(file, good);
        change("1-of-2.json", [&](json& shard) {
            json& number = shard["parts"][0]["made"][json::json_pointer(place)];
            ASSERT_TRUE(number.is_number()) << place;
            number = 250'000'000;
        });
        expect_refused("merge " + parts + " -o " + merged, "part 0 is damaged");
    }
}

TEST_F(BadShards, WhatCannotBeSharedIsSaid) {
    for (const char* text : {"0/2", "3/2", "1", "a/b", "1/0", "-1/2"})
        expect_refused(arguments + " --shard=" + text + " -o " + parts, "--shard: ");
    expect_refused("inspect spheres-l1 --shard 1/2", "say where to keep the shard, with -o DIR");
    expect_refused("bench spheres-l1 --shard 1/2", "say where to keep the shard, with -o DIR");
    expect_refused("bench spheres-l1 --layout float8 --coherent --shard 1/2 -o " + parts,
                   "a front is kept from each frame to the next");
}

TEST_F(BadShards, AnInterruptedOneIsNotWritten) {
    const std::string scene = folder / "endless.json";
    write_text(scene, endless_scene);
    const ProgramRun run = run_scb_interrupted(
        "render pairs " + scene + " --frames 0:2799" + small_pictures + " --shard 1/2 -o " + parts,
        [&](pid_t) { return fs::exists(parts) && files_in(parts) > 2; });
    EXPECT_EQ(run.status, 130);
    EXPECT_NE(run.err.find("the shard is to be made again"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(parts + "/shards/1-of-2.json"));
}

}  // namespace
}  // namespace scb::app
