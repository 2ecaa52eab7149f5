#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "render/files/image_file.h"
#include "tests/app/program.h"
#include "tests/png_chunks.h"
#include "tests/scenes/recordings/recording_block.h"

namespace scb::app {
namespace {

using nlohmann::json;

struct RenderQueries : testing::Test {
    TemporaryFolder folder;
    std::string out = folder / "out", trace_file = folder / "t.scbrec";

    json index_of(const std::string& arguments) {
        const ProgramRun run =
            run_scb("render " + arguments + " --size 320x240 --samples 1 -o " + out);
        EXPECT_EQ(run.status, 0) << arguments << run.err;
        return json::parse(file_text(out + "/index.json"));
    }
};

TEST_F(RenderQueries, ShowTheCountsThatCollideGives) {
    for (const char* command : {"pairs ", "pairs --heat triangles ", "rejections "})
        for (const char* options : {"", "--volume obb", "--volume ball --level 4",
                                    "--test extents --descent volume --max-pairs 5"}) {
            const std::string arguments = "spheres-l1 --frames 0,100,250 " + std::string(options);
            const json index = index_of(command + arguments);
            const json live = json::parse(run_scb("collide --json " + arguments).out);
            // Of rejections, one for all frames together too.
            ASSERT_EQ(index["files"].size(), std::string(command) == "rejections " ? 4u : 3u);
            for (std::size_t i = 0; i < 3; ++i)
                for (const auto& [key, value] : live["frames"][i].items())
                    EXPECT_EQ(index["files"][i][key], value) << command << options << key;
            for (const char* key : {"scene", "volume", "test", "descent", "level", "max_pairs"})
                EXPECT_EQ(index.value(key, json()), live.value(key, json())) << key;
        }
}

TEST_F(RenderQueries, WithoutPanelHaveTheSceneAlone) {
    const auto drawn = [&](const std::string& arguments) {
        const ProgramRun run = run_scb("render " + arguments + " --samples 1 --ids -o " + out);
        EXPECT_EQ(run.status, 0) << arguments << run.err;
        const json file = json::parse(file_text(out + "/index.json"))["files"][0];
        return std::pair{render::read_png(out + "/" + file["file"].get<std::string>()),
                         render::read_png(out + "/" + file["ids"].get<std::string>())};
    };
    const std::string small = " spheres-l1 --frames 100 --no-panel --size 96x64";
    for (const std::string what : {"pairs", "rejections"}) {
        const auto [picture, ids] = drawn(what + small);
        EXPECT_EQ(picture.width, 96);
        EXPECT_EQ(picture.height, 64);
        // What is drawn is of things of the scene, or of the meshes behind them.
        for (int y = 0; what == "pairs" && y < 64; ++y)
            for (int x = 0; x < 96; ++x)
                EXPECT_TRUE(render::pixel(picture, x, y) == render::pixel(picture, 0, 0) ||
                            render::pixel(ids, x, y) != (render::Rgba8{0, 0, 0, 0}))
                    << what << x << "," << y;
    }
    // Other words and counts make no other picture.
    EXPECT_EQ(drawn("pairs" + small).first,
              drawn("pairs" + small + " --test extents --descent area").first);
    EXPECT_EQ(
        run_scb("render levels spheres-l1 --level 3 --no-panel --size 64x64 -o " + out).status, 0);
}

// glTF has y up, and others say nothing.
TEST_F(RenderQueries, ShowGltfFilesWithYUp) {
    const std::string gltf = folder / "m.gltf", off = folder / "m.off";
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 2, 0};
    write_text(folder / "m.bin",
               std::string(reinterpret_cast<const char*>(corners), sizeof corners));
    write_text(gltf,
               R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri": "m.bin"}]})");
    write_text(off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 2 0\n3 0 1 2\n");
    const auto up_of = [&](const std::string& arguments) {
        return index_of(arguments)["camera"].value("up", json());
    };
    const json y = {0, 1, 0};
    EXPECT_EQ(up_of("pairs " + gltf + " " + gltf), y);
    EXPECT_EQ(up_of("levels " + gltf + " --levels 0"), y);
    EXPECT_NE(up_of("pairs " + gltf + " " + gltf + " --up z"), y);
    EXPECT_NE(up_of("pairs " + gltf + " " + gltf + " --camera orbit:10,20"), y);
    EXPECT_NE(up_of("pairs " + off + " " + off), y);
    EXPECT_NE(up_of("pairs " + off + " " + gltf), y);
}

TEST_F(RenderQueries, AreTheSameFromATrace) {
    const std::string mesh = folder / "m.off";
    write_text(mesh,
               "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
               "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    for (const std::string& scene :
         {std::string("spheres-l1 --volume scb --test corrected --margin 0.01 --frames 100,250"),
          std::string("knots-l1 --volume obb --level 5 --frames 3,4"),
          mesh + " " + mesh + " --pose 1,0,0,0.25,0,1,0,0.125,0,0,1,0 --frames 0"}) {
        ASSERT_EQ(run_scb("trace " + scene + " -o " + trace_file).status, 0);
        for (const char* command :
             {"pairs ", "pairs --heat volumes ", "pairs --heat wasted ", "rejections "}) {
            const json live = index_of(command + scene + " --ids");
            const auto bytes_of = [&](const json& index) {
                std::vector<std::string> bytes;
                for (const json& file : index["files"])
                    for (const char* key : {"file", "ids"})
                        if (file.contains(key))
                            bytes.push_back(png_without_texts(
                                file_text(out + "/" + file[key].get<std::string>())));
                return bytes;
            };
            const std::vector<std::string> bytes = bytes_of(live);
            const json again = index_of(command + trace_file + " --frames all --ids");
            EXPECT_EQ(again, live);
            EXPECT_EQ(bytes_of(again), bytes);
        }
    }
}

TEST_F(RenderQueries, IdsAreThoseOfTheIndex) {
    const json pairs = index_of("pairs spheres-l1 --frames 100 --ids"), ranges = pairs["ids"];
    ASSERT_EQ(ranges.size(), 4u);
    const auto range_of = [&](std::uint32_t id) -> std::string {
        for (const json& r : ranges)
            if (id >= r["first"] &&
                id < r["first"].get<std::uint32_t>() + r["count"].get<std::uint32_t>())
                return r["what"].get<std::string>() + " " + r["body"].get<std::string>();
        return id == 0 ? "nothing" : "other";
    };
    const auto seen = [&](const json& index) {
        std::set<std::string> kinds;
        const std::string file = out + "/" + index["files"][0]["ids"].get<std::string>();
        for (const std::uint32_t id : render::unpack_ids(render::read_png(file)).ids)
            kinds.insert(range_of(id));
        return kinds;
    };
    // "other": the segments in which triangles meet.
    const json pair_ids = pairs["files"][0]["pair_ids"];
    EXPECT_EQ(pair_ids["count"], pairs["files"][0]["pairs"]);
    EXPECT_EQ(pair_ids["first"],
              ranges[3]["first"].get<std::uint32_t>() + ranges[3]["count"].get<std::uint32_t>());
    EXPECT_EQ(seen(pairs), (std::set<std::string>{"nothing", "triangle A", "triangle B", "other"}));
    std::set<std::string> with_leaves =
        seen(index_of("pairs spheres-l1 --frames 100 --ids --volume ball --leaves"));
    EXPECT_EQ(with_leaves.erase("node A") + with_leaves.erase("node B") > 0, true);
    EXPECT_EQ(with_leaves, (std::set<std::string>{"nothing", "triangle A", "triangle B", "other"}));
    // Once the way to do without them, and still taken.
    json without_leaves = index_of("pairs spheres-l1 --frames 100 --ids --no-leaves");
    without_leaves.erase("earlier");
    EXPECT_EQ(without_leaves, pairs);
    // The lines in which triangles meet have the ids of A's triangles, and hide B's triangles here.
    EXPECT_EQ(seen(index_of("rejections spheres-l1 --frames 100 --ids")),
              (std::set<std::string>{"nothing", "node A", "node B", "triangle A"}));
    EXPECT_EQ(seen(index_of("rejections spheres-l1 --frames 100 --ids --body B")),
              (std::set<std::string>{"nothing", "node B", "triangle B"}));
}

TEST_F(RenderQueries, TellWhatIsUnderAPixel) {
    const json index = index_of("rejections spheres-l1 --frames 100 --focus 1 --ids"),
               ranges = index["ids"];
    const render::IdImage ids = render::unpack_ids(
        render::read_png(out + "/" + index["files"][0]["ids"].get<std::string>()));
    const std::string start =
        "render rejections spheres-l1 --frames 100 --focus 1 --size 320x240 --samples 1 -o " + out +
        " --pick ";
    for (const auto& [x, y] : {std::pair{0, 0}, {60, 120}, {120, 120}, {200, 100}}) {
        const std::uint32_t id = ids.ids[static_cast<std::size_t>(y * 320 + x)];
        std::string expected = "nothing";
        for (const json& range : {ranges[0], ranges[1]}) {
            const std::uint32_t first = range["first"];
            if (id >= first && id - first < range["count"].get<std::uint32_t>())
                expected = "node " + std::to_string(id - first) + " of " +
                           range["body"].get<std::string>() + ", depth ";
        }
        const ProgramRun run = run_scb(start + std::to_string(x) + "," + std::to_string(y));
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.out.find(": " + expected), std::string::npos) << run.out << expected;
    }
    EXPECT_EQ(ids.ids[0], 0u);
    EXPECT_NE(ids.ids[120 * 320 + 60], 0u);
}

TEST_F(RenderQueries, StepThroughATraversal) {
    const json index = index_of("rejections spheres-l1 --frames 100 --steps 4000");
    const json whole = index_of("rejections spheres-l1 --frames 100 --focus 1")["files"][0];
    const std::size_t n_v = whole["n_v"];
    ASSERT_EQ(index["files"].size(), (n_v + 3999) / 4000);
    std::size_t tests = 0;
    for (const json& file : index["files"]) {
        tests = std::min<std::size_t>(tests + 4000, n_v);
        EXPECT_EQ(file["tests"], tests);
        EXPECT_EQ(file["n_v"], tests);
    }
    EXPECT_EQ(tests, n_v);
    for (const char* key : {"pairs", "n_p", "n_u", "stages", "depth", "complete"})
        EXPECT_EQ(index["files"].back()[key], whole[key]);
}

TEST_F(RenderQueries, StopBetweenTwoStepsAtASignal) {
    const ProgramRun run = run_scb_interrupted(
        "render rejections spheres-l1 --frames 100 --steps 1 --size 320x240 --samples 1 -o " + out,
        [&](pid_t) { return std::filesystem::exists(out) && files_in(out) > 2; });
    ASSERT_EQ(run.status, 130) << run.err;
    EXPECT_NE(run.err.find("interrupted"), std::string::npos) << run.err;
    const json index = json::parse(file_text(out + "/index.json"));
    EXPECT_LT(index["files"].size(), 17499u);
}

TEST_F(RenderQueries, DoNotReplaceWhatTheyRead) {
    std::filesystem::create_directory(out);
    const std::string input = out + "/index.json";
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 100 -o " + trace_file).status, 0);
    std::filesystem::rename(trace_file, input);
    const std::string before = file_text(input);
    for (const char* command : {"pairs ", "rejections ", "traversal "}) {
        const ProgramRun run = run_scb("render " + std::string(command) + input + " -o " + out);
        EXPECT_EQ(run.status, 2) << command;
        EXPECT_NE(run.err.find("which this command reads"), std::string::npos) << run.err;
        EXPECT_EQ(file_text(input), before) << command;
    }
}

TEST_F(RenderQueries, RefuseDepthsAndOptionsThatAreNone) {
    for (const auto& [arguments, said] : {
             std::pair<std::string, std::string>{"--depth leaves", "give a level such as 7"},
             {"--depth 5,7", "give a level such as 7"},
             {"--depth 1:9:4", "give a level such as 7"},
             {"--depth 9:1", "the levels 0 to"},
             {"--depth 99", "the levels 0 to"},
             {"--depth ''", "--depth"},
             {"--body ''", "--body"},
             {"--heat volumes", "unknown option '--heat' of `scb render rejections`"},
             {"--no-such thing", "unknown option '--no-such'"},
         }) {
        const ProgramRun run =
            run_scb("render rejections spheres-l1 --frames 100 " + arguments + " -o " + out);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_NE(run.err.find(said), std::string::npos) << arguments << ": " << run.err;
        EXPECT_FALSE(std::filesystem::exists(out)) << arguments;
    }
    const ProgramRun heat =
        run_scb("render pairs spheres-l1 --frames 100 --heat volumes --leaves -o " + out);
    EXPECT_EQ(heat.status, 2);
    EXPECT_NE(heat.err.find("leave out --leaves, or --heat"), std::string::npos) << heat.err;
}

TEST_F(RenderQueries, ACameraFollowsTheContact) {
    const json index = index_of("pairs spheres-l1 --frames 20,250,480 --camera contact");
    // At frame 20 the spheres just touch; at 250, one inside the other, nothing meets.
    const auto distance = [&](std::size_t i) {
        return index["files"][i]["camera"]["distance"].get<double>();
    };
    EXPECT_LT(distance(0), distance(1) / 2);
    EXPECT_LT(distance(2), distance(1) / 2);
    EXPECT_FALSE(index.contains("camera"));
    EXPECT_TRUE(index_of("pairs spheres-l1 --frames 20").contains("camera"));
}

TEST_F(RenderQueries, RefuseWhatMakesNoSense) {
    ASSERT_EQ(run_scb("trace spheres-l1 --frames 0,100 -o " + trace_file).status, 0);
    const std::string scene = folder / "s.json", of_scene = folder / "s.scbrec";
    write_text(scene, endless_scene);
    ASSERT_EQ(run_scb("trace " + scene + " --frames 0 -o " + of_scene).status, 0);
    std::string moved = endless_scene, other = endless_scene;
    moved.replace(moved.find("1.98"), 4, "1.97");
    other.replace(other.find("\"subdivisions\": 3"), 17, "\"subdivisions\": 2");
    std::string newer = file_text(of_scene);
    const std::string version = json::parse(run_scb("--version --json").out)["scb"];
    newer[newer.find(version)] = '9';
    const std::vector<std::uint8_t> resealed =
        scenes::with_fitting_checksums({newer.begin(), newer.end()});
    newer.assign(resealed.begin(), resealed.end());
    write_text(folder / "newer.scbrec", newer);
    const auto refused = [&](const std::string& arguments, const std::string& part) {
        const ProgramRun run = run_scb("render " + arguments + " -o " + out);
        EXPECT_EQ(run.status, 2) << arguments << run.err;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        EXPECT_NE(run.err.find(part), std::string::npos) << arguments << run.err;
    };
    refused("pairs spheres-l1 --frames 500", "frames 0 to 499");
    refused("pairs " + trace_file + " --frames 50", "has no frame 50");
    refused("pairs " + trace_file + " --test extents", "--test");
    refused("pairs cone.off", "there is no such file");
    refused("pairs spheres-l1 --camera up", "--camera");
    refused("levels spheres-l1 --camera contact", "levels have no contact");
    refused("pairs spheres-l1 --clip 0,0,0,1", "--clip 0,0,0,1: the normal X,Y,Z must not be zero");
    refused("rejections spheres-l1 --clip 0,0,1", "four numbers are expected; give X,Y,Z,D");
    refused("levels spheres-l1 --clip 0,0,1,0,5", "four numbers are expected");
    refused("levels spheres-l1 --clip 0,0,z,1", "number 3 cannot be read");
    refused("levels spheres-l1 --clip 0,inf,0,1", "number 2 must be from -1e+70 to 1e+70");
    refused("pairs spheres-l1 --clip 0,0,1,nan", "number 4 must be from");
    refused("pairs spheres-l1 --clip 0,0,1,-1e300", "number 4 must be from");
    refused("pairs spheres-l1 --clip 1e-999,0,1,0", "number 1 cannot be read");
    refused("rejections spheres-l1 --steps 0", "--steps 0: give at least 1");
    refused("pairs spheres-l1 --pick 1280,0", "the pixels 0,0 to 1279,719");
    refused("pairs spheres-l1 --pick 12", "this is not a pixel");
    refused("pairs spheres-l1 --pick 1,x", "is not a whole number");
    refused("pairs spheres-l1 --heat tests", "--heat tests: give volumes, triangles or wasted");
    refused("pairs spheres-l1 --heat-end 100", "and --heat");
    refused("pairs spheres-l1 --heat volumes --heat-end 1", "give at least 2");
    refused("rejections spheres-l1 --depth 0:99", "levels 0 to");
    refused("rejections spheres-l1 --depth 5:2", "--depth");
    refused("rejections spheres-l1 --stage slab-a", "'slab-a' is not an ending of these queries");
    refused("rejections spheres-l1 --stage gjk", "ball-ball, slab-ball");
    refused("rejections spheres-l1 --body C", "the bodies are A and B");
    refused("rejections spheres-l1 --by mean", "--by mean");
    refused("rejections spheres-l1 --opacity 0", "--opacity");
    refused("pairs spheres-l1 --compare scb,ball --no-panel", "only captions say which is which");
    refused("pairs spheres-l1 --no-panel --size 63x64", "give 64x64 to");
    refused("rejections spheres-l1 --focus 0", "--focus 0: give a share");
    refused("rejections spheres-l1 --focus 1.5", "--focus 1.5: give a share");
    refused("pairs " + (folder / "newer.scbrec"), "was recorded by scb 9.0.0");
    write_text(scene, moved);
    refused("pairs " + of_scene, of_scene + ": at frame 0 of ");
    const ProgramRun explained = run_scb("explain " + of_scene + " --frame 0 --pair 0,0");
    EXPECT_EQ(explained.status, 2);
    EXPECT_NE(explained.err.find("the bodies are elsewhere"), std::string::npos) << explained.err;
    write_text(scene, other);
    refused("rejections " + of_scene, "was recorded when the mesh of left had 1,280 triangles");
    std::filesystem::remove(scene);
    refused("pairs " + of_scene, "there is no such");
}

TEST_F(RenderQueries, OfOneFrameGoIntoTheFileThatIsNamed) {
    const std::string scene = " spheres-l1 --frames 100 --size 320x240 ";
    std::filesystem::create_directory(folder / "one");
    const std::string file = folder / "one/part.png";
    for (const std::string command : {"render pairs", "render rejections", "render traversal"}) {
        const ProgramRun usual = run_scb(command + scene + "-o " + out);
        const ProgramRun run = run_scb(command + scene + "-o " + file);
        EXPECT_EQ(run.status, 0) << command << run.err;
        EXPECT_EQ(run.out, file + "\n");
        EXPECT_EQ(file_text(file), file_text(lines(usual.out)[0])) << command;
        EXPECT_EQ(files_in(folder / "one"), 1u);
    }
    const ProgramRun with_json = run_scb("render pairs" + scene + "--ids --json -o " + file);
    const json files = json::parse(with_json.out)["files"];
    EXPECT_EQ(files[0]["file"], "part.png");
    EXPECT_EQ(files[0]["ids"], "part_ids.png");
    EXPECT_EQ(files_in(folder / "one"), 2u);
}

TEST_F(RenderQueries, OfSeveralPicturesAreRefusedInOneFile) {
    for (const auto& [arguments, sentence] :
         std::initializer_list<std::pair<std::string, std::string>>{
             {"pairs --frames 0,100",
              "this run draws 2 pictures; name a folder, or give one frame"},
             {"pairs --frames 100 --sheet",
              "draws 2 pictures; name a folder, or leave out --sheet"},
             {"rejections --frames 100 --steps 500", "name a folder, or leave out --steps"},
             {"traversal --frames 0,100", "this run draws 2 pictures"},
             {"levels --levels 3,4", "this run draws 3 pictures; name a folder, or give one level"},
             {"pairs --frames 100 --shard 1/2", "shards are kept and joined in folders"}}) {
        const std::string command = arguments.substr(0, arguments.find(' '));
        const ProgramRun run =
            run_scb("render " + command + " spheres-l1" + arguments.substr(command.size()) +
                    " -o " + (folder / "new/part.png"));
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        EXPECT_FALSE(std::filesystem::exists(folder / "new"));
    }
    for (const std::string command : {"bench", "inspect", "tune"})
        EXPECT_NE(run_scb(command + " spheres-l1 -o " + (folder / "new/part.png"))
                      .err.find("this command writes several files"),
                  std::string::npos)
            << command;
}

}  // namespace
}  // namespace scb::app
