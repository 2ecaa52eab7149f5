#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/collide/index_pairs.h"
#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "scb/any_collide.h"
#include "scenes/scene/load_scene.h"
#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

Collision query(const std::string& name, int frame, VolumeKind kind) {
    const scenes::Scene scene = scenes::load_scene({name});
    std::vector<AnyHierarchy> h;
    for (const scenes::NamedMesh& m : scene.meshes) {
        const auto topology = std::make_shared<const Topology>(build_topology(m.mesh));
        h.push_back(fit_any(kind, topology, leaf_order(m.mesh, *topology)));
    }
    const scenes::Body &a = scene.bodies[0], &b = scene.bodies[1];
    return collide(
        h[a.mesh], scene.meshes[a.mesh].mesh, h[b.mesh], scene.meshes[b.mesh].mesh,
        relative_pose(scenes::pose_at(a.motion, frame), scenes::pose_at(b.motion, frame)));
}

TEST(CollideCommand, SpeaksOfTheLibrarysCounts) {
    const ProgramRun run = run_scb("collide spheres-l1 --frames 100,250 --json");
    ASSERT_EQ(run.status, 0) << run.err;
    const json result = json::parse(run.out);
    EXPECT_EQ(result["test"], "symmetric");
    ASSERT_EQ(result["frames"].size(), 2u);
    for (const json& frame : result["frames"]) {
        const Collision found = query("spheres-l1", frame["frame"], VolumeKind::scb);
        EXPECT_EQ(frame["pairs"], found.pairs.size());
        EXPECT_EQ(frame["pairs_hash"], hash_text(pairs_hash(found.pairs)));
        EXPECT_EQ(frame["n_v"], found.n_v);
        EXPECT_EQ(frame["n_p"], found.n_p);
        EXPECT_EQ(frame["n_u"], found.n_u);
        EXPECT_EQ(frame["depth"], found.depth);
        std::uint64_t sum = 0;
        for (const auto& [stage, tests] : frame["stages"].items()) {
            EXPECT_EQ(tests, found.stages[static_cast<std::size_t>(*stage_of(stage))]);
            sum += tests.get<std::uint64_t>();
        }
        EXPECT_EQ(sum, found.n_v);
    }
}

TEST(CollideCommand, TableCsvAndJsonAgree) {
    const std::string arguments = "collide spheres-l1 --frames 0:499:125 --volume obb";
    const std::vector<std::string> table = lines(run_scb(arguments).out),
                                   csv = lines(run_scb(arguments + " --csv").out);
    const json frames = json::parse(run_scb(arguments + " --json").out)["frames"];
    ASSERT_EQ(csv.size(), 1 + frames.size());
    // Title, empty, header, frames, mean, empty, which body lies inside the other, empty, contact.
    ASSERT_EQ(table.size(), 8 + frames.size());
    EXPECT_EQ(table[table.size() - 3],
              "Where no triangles intersect: A lies inside B in 1 of 4 frames.");
    EXPECT_NE(csv[0].find("axis-a2xb2"), std::string::npos);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::istringstream cells(table[3 + i]);
        std::uint64_t frame, pairs, n_v, n_p, n_u;
        cells >> frame >> pairs >> n_v >> n_p >> n_u;
        EXPECT_EQ(frames[i]["frame"], frame);
        EXPECT_EQ(frames[i]["pairs"], pairs);
        EXPECT_EQ(frames[i]["n_v"], n_v);
        EXPECT_EQ(frames[i]["n_p"], n_p);
        EXPECT_EQ(frames[i]["n_u"], n_u);
        const std::string start = std::to_string(frame) + "," + std::to_string(pairs) + "," +
                                  std::to_string(n_v) + "," + std::to_string(n_p) + "," +
                                  std::to_string(n_u) + ",";
        EXPECT_EQ(csv[1 + i].substr(0, start.size()), start);
    }
}

TEST(CollideCommand, SaysHowFarBodiesAreApartThatDoNotMeet) {
    const std::string apart = run_scb("collide spheres-l1 --frames 0,2").out;
    EXPECT_NE(apart.find("No triangles intersect: the boxes of A and B are "), std::string::npos)
        << apart;
    EXPECT_NE(apart.find("in frame 2, where they are nearest"), std::string::npos) << apart;
    const std::string near = run_scb("collide knots-l1 --frames 0").out;
    EXPECT_NE(near.find("No triangles intersect, though the boxes of A and B overlap."),
              std::string::npos)
        << near;
    EXPECT_EQ(run_scb("collide spheres-l1 --frames 100").out.find("No triangles"),
              std::string::npos);
}

/// A scene of spheres, each with a radius and a center. The spheres of a body are one mesh.
std::string sphere_scene(const TemporaryFolder& folder, const std::string& bodies) {
    const std::string scene = folder / "spheres.json";
    write_text(scene, R"({"scb_scene": 1, "name": "spheres", "models": [
        {"name": "large", "icosphere": {"subdivisions": 2, "radius": 1}},
        {"name": "small", "icosphere": {"subdivisions": 1, "radius": 0.2}},
        {"name": "open", "file": "open.off"}, {"name": "two", "file": "two.off"}],
        "bodies": [)" + bodies +
                          "]}");
    // A tetrahedron without its bottom, and one of two whose other is far away.
    write_text(folder / "open.off",
               "OFF\n4 3 0\n0 0 9\n9 0 -9\n-9 9 -9\n-9 -9 -9\n3 0 1 2\n3 0 2 3\n3 0 3 1\n");
    write_text(folder / "two.off",
               "OFF\n8 8 0\n0 0 .1\n.1 0 0\n0 .1 0\n0 0 0\n9 9 9\n8 9 9\n9 8 9\n9 9 8\n"
               "3 0 1 2\n3 0 2 3\n3 0 3 1\n3 3 2 1\n3 4 5 6\n3 4 6 7\n3 4 7 5\n3 7 6 5\n");
    return scene;
}

/// Three bodies that meet in one pair, with a comma in a name; a small body inside the first; and a
/// body far away.
std::string scene_of_five(const TemporaryFolder& folder) {
    return sphere_scene(folder, R"(
        {"name": "base", "model": "large"},
        {"name": "arm", "model": "large", "position": [1.5, 0, 0]},
        {"name": "nut, M3", "model": "small", "position": [0.2, 0.1, 0]},
        {"name": "tool", "model": "small", "position": [2.5, 0, 0]},
        {"name": "far", "model": "small", "position": [0, 0, 40]})");
}

TEST(CollideCommand, QueriesAllPairsOfBodiesInTheirOrder) {
    const TemporaryFolder folder;
    const std::string scene = scene_of_five(folder);
    const json result = json::parse(run_scb("collide " + scene + " --json").out);
    std::vector<std::string> bodies;
    for (const json& body : result["bodies"]) bodies.push_back(body["name"]);
    EXPECT_EQ(bodies, (std::vector<std::string>{"base", "arm", "nut, M3", "tool", "far"}));
    ASSERT_EQ(result["frames"].size(), 1u);
    EXPECT_EQ(result["frames"][0]["frame"], 0);
    const json& queries = result["frames"][0]["queries"];
    ASSERT_EQ(queries.size(), 10u);
    std::size_t next = 0, sum = 0;
    for (std::size_t a = 0; a < bodies.size(); ++a)
        for (std::size_t b = a + 1; b < bodies.size(); ++b) {
            json query = queries[next++];
            EXPECT_EQ(query["bodies"], json({bodies[a], bodies[b]}));
            query.erase("bodies");
            sum += query["pairs"].get<std::size_t>();
            json alone = json::parse(run_scb("collide " + scene + " --json --bodies '" + bodies[a] +
                                             "," + bodies[b] + "'")
                                         .out)["frames"][0];
            alone.erase("frame");
            EXPECT_EQ(query, alone);
        }
    EXPECT_EQ(result["mean"]["pairs"], sum);
    EXPECT_GT(sum, 0u);
    EXPECT_EQ(
        result["inside"],
        json::parse(R"([{"frame": 0, "body": "nut, M3", "in": "base", "parts": 1, "of": 1}])"));
}

TEST(CollideCommand, RefusesNamesOfBodiesThatMeanSeveralPairs) {
    const TemporaryFolder folder;
    const std::string scene = sphere_scene(folder, R"(
        {"name": "a", "model": "large"}, {"name": "a,b", "model": "large"},
        {"name": "b,c", "model": "large"}, {"name": "c", "model": "large"})");
    const ProgramRun both = run_scb("collide " + scene + " --bodies a,b,c");
    EXPECT_EQ(both.status, 2);
    EXPECT_NE(both.err.find("--bodies a,b,c: several pairs of bodies have these names"),
              std::string::npos)
        << both.err;
    EXPECT_EQ(run_scb("collide " + scene + " --bodies a,b,b,c").status, 0);
    EXPECT_NE(run_scb("collide " + scene + " --bodies a,a,b,x").err.find("'b' is not a body"),
              std::string::npos);
}

TEST(CollideCommand, NamesTheBodiesOfEachQueryInTableCsvAndPairs) {
    const TemporaryFolder folder;
    const std::string command = "collide " + scene_of_five(folder);
    const json queries = json::parse(run_scb(command + " --json").out)["frames"][0]["queries"];
    const std::string pairs_file = folder / "pairs.csv";
    const std::string text = run_scb(command + " --pairs-out " + pairs_file).out;
    const std::vector<std::string> table = lines(text),
                                   csv = lines(run_scb(command + " --csv").out),
                                   pairs = lines(file_text(pairs_file));
    EXPECT_NE(table[0].find("tool (80 triangles) and far (80 triangles), 10 pairs of bodies, scb"),
              std::string::npos)
        << table[0];
    EXPECT_TRUE(table[2].ends_with("  bodies")) << table[2];
    EXPECT_TRUE(csv[0].ends_with(",body_a,body_b")) << csv[0];
    EXPECT_EQ(pairs[0], "frame,body_a,body_b,triangle_a,triangle_b");
    ASSERT_GE(table.size(), 13u);
    ASSERT_EQ(csv.size(), 11u);
    std::size_t sum = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const std::string a = queries[i]["bodies"][0], b = queries[i]["bodies"][1];
        EXPECT_TRUE(table[3 + i].ends_with("  " + a + " and " + b)) << table[3 + i];
        const auto quoted = [](const std::string& name) {
            return name == "nut, M3" ? "\"nut, M3\"" : name;
        };
        EXPECT_TRUE(csv[1 + i].ends_with("," + quoted(a) + "," + quoted(b))) << csv[1 + i];
        const std::string start = "0," + quoted(a) + "," + quoted(b) + ",";
        const auto of_query = std::count_if(
            pairs.begin(), pairs.end(), [&](const auto& line) { return line.starts_with(start); });
        EXPECT_EQ(queries[i]["pairs"], static_cast<std::size_t>(of_query));
        sum += static_cast<std::size_t>(of_query);
    }
    EXPECT_EQ(pairs.size(), 1 + sum);
    EXPECT_NE(
        text.find("\n8 of 10 pairs of bodies have no contact: base and nut, M3; base and tool;"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("\nWhere no triangles intersect: nut, M3 lies inside base.\n"),
              std::string::npos)
        << text;
}

TEST(CollideCommand, SaysWhichBodyLiesInsideTheOther) {
    const TemporaryFolder folder;
    const std::string outer = R"({"name": "outer", "model": "large"})",
                      inner = R"({"name": "inner", "model": "small", "position": [0.2, 0.1, 0]})",
                      open = R"({"name": "funnel", "model": "open"})",
                      two = R"({"name": "two", "model": "two"})";
    for (const std::string& bodies : {outer + "," + inner, inner + "," + outer}) {
        const std::string command = "collide " + sphere_scene(folder, bodies);
        const std::string text = run_scb(command).out;
        EXPECT_NE(text.find("\nNo triangles intersect: inner lies inside outer.\n"),
                  std::string::npos)
            << text;
        const json counts = json::parse(run_scb(command + " --json").out);
        EXPECT_EQ(counts["inside"], json::parse(R"([{"frame": 0, "body": "inner", "in": "outer",
                                                     "parts": 1, "of": 1}])"));
        EXPECT_FALSE(counts.contains("not_closed"));
        // Of pairs of nodes nothing follows for triangles.
        EXPECT_EQ(run_scb(command + " --level 2").out.find("inside"), std::string::npos);
    }
    const std::string parts = run_scb("collide " + sphere_scene(folder, outer + "," + two)).out;
    EXPECT_NE(parts.find("No triangles intersect: 1 of 2 parts of two lies inside outer.\n"),
              std::string::npos)
        << parts;
    const std::string in_open = "collide " + sphere_scene(folder, open + "," + inner);
    const std::string unknown = run_scb(in_open).out;
    EXPECT_NE(unknown.find("No triangles intersect, though the boxes of funnel and inner overlap.\n"
                           "Whether inner lies inside funnel is not judged: funnel is not "
                           "closed.\n"),
              std::string::npos)
        << unknown;
    const json counts = json::parse(run_scb(in_open + " --json").out);
    EXPECT_EQ(counts["inside"], json::array());
    EXPECT_EQ(counts["not_closed"], json::array({"funnel"}));
}

TEST(CollideCommand, SaysInHowManyFramesABodyLiesInsideTheOther) {
    const TemporaryFolder folder;
    // From the middle to the right: inside, through the surface, and apart.
    const std::string scene = sphere_scene(
        folder, R"({"name": "outer", "model": "large"}, {"name": "inner", "model": "small",
            "position": {"from": [0, 0, 0], "to": [2.5, 0, 0], "frames": 5}})");
    write_text(scene, "{\"frames\": 5, " + file_text(scene).substr(1));
    const std::string all = run_scb("collide " + scene + " --frames 0:4").out;
    EXPECT_NE(all.find("\nWhere no triangles intersect: inner lies inside outer in 2 of 5 "
                       "frames.\n"),
              std::string::npos)
        << all;
    const std::string some = run_scb("collide " + scene + " --frames 0,1,4").out;
    EXPECT_NE(some.find("\nNo triangles intersect: inner lies inside outer in 2 of 3 frames.\n"),
              std::string::npos)
        << some;
    const json inside =
        json::parse(run_scb("collide " + scene + " --frames 0:4 --json").out)["inside"];
    ASSERT_EQ(inside.size(), 2u);
    EXPECT_EQ(inside[0]["frame"], 0);
    EXPECT_EQ(inside[1]["frame"], 1);
}

TEST(CollideCommand, ListsThePairs) {
    const TemporaryFolder folder;
    const std::string file = folder / "pairs.csv";
    ASSERT_EQ(run_scb("collide spheres-l1 --frames 100 --pairs-out " + file).status, 0);
    std::string expected = "frame,triangle_a,triangle_b\n";
    for (const IndexPair& pair : query("spheres-l1", 100, VolumeKind::ball).pairs)
        expected += "100," + std::to_string(pair.a) + "," + std::to_string(pair.b) + "\n";
    EXPECT_EQ(file_text(file), expected);
}

TEST(CollideCommand, FindsThePairsOfABodyAgainstItself) {
    const TemporaryFolder folder;
    const std::string file = folder / "pairs.csv";
    const ProgramRun table = run_scb("collide soup --frame 0 --bodies A,A --pairs-out " + file);
    ASSERT_EQ(table.status, 0) << table.err;
    EXPECT_EQ(
        lines(table.out)[0],
        "soup: A (2,000 triangles) against itself, scb hierarchies, test symmetric, descent by "
        "radius");
    const json found = json::parse(run_scb("collide soup --frame 0 --bodies A,A --json").out);
    EXPECT_EQ(found["query"], "self");
    const std::vector<std::string> rows = lines(file_text(file));
    EXPECT_EQ(found["frames"][0]["pairs"], rows.size() - 1);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        unsigned frame = 0, a = 0, b = 0;
        ASSERT_EQ(std::sscanf(rows[i].c_str(), "%u,%u,%u", &frame, &a, &b), 3);
        EXPECT_LT(a, b);
    }
    // The pairs do not depend on the type of the volumes.
    EXPECT_EQ(json::parse(run_scb("collide soup --frame 0 --bodies A,A --volume rss --json")
                              .out)["frames"][0]["pairs"],
              rows.size() - 1);
    for (const char* command : {"bench soup --bodies A,A", "tune soup --bodies A,A"}) {
        const ProgramRun run = run_scb(command);
        EXPECT_EQ(run.status, 2) << command;
        EXPECT_NE(run.err.find("two bodies"), std::string::npos) << run.err;
    }
    const ProgramRun one = run_scb("collide cone --bodies B,B");
    EXPECT_EQ(one.status, 0) << one.err;
}

TEST(CollideCommand, SaysThatThePrintedTestMissesPairs) {
    const ProgramRun run = run_scb("collide spheres-l1 --frames 100 --test printed --json");
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.err.find("pairs may be missing"), std::string::npos);
    EXPECT_LT(json::parse(run.out)["frames"][0]["pairs"],
              query("spheres-l1", 100, VolumeKind::scb).pairs.size());
}

TEST(CollideCommand, EndsAtTheFirstContactOrAtALevel) {
    const json first =
        json::parse(run_scb("collide spheres-l1 --frames 100 --first --json").out)["frames"][0];
    EXPECT_EQ(first["pairs"], 1);
    EXPECT_EQ(first["complete"], false);
    const json level =
        json::parse(run_scb("collide spheres-l1 --frames 100 --level 5 --json").out)["frames"][0];
    EXPECT_GT(level["pairs"], 32);
    EXPECT_EQ(level["n_p"], 0);
    EXPECT_EQ(level["depth"], 10);
}

// Boxes that lie on each other only touch. Spheres that pass through each other cross.
TEST(CollideCommand, TellsCrossingFromTouching) {
    const std::string stack = "collide stack --frames 20 ";
    const auto expect_in = [](const std::string& part, const std::string& whole) {
        EXPECT_NE(whole.find(part), std::string::npos) << whole;
    };
    const json all = json::parse(run_scb(stack + "--contacts all --json").out)["frames"][0];
    EXPECT_EQ(all["pairs"], 6004);
    EXPECT_EQ(all["touching"], 6004);
    EXPECT_EQ(json::parse(run_scb(stack + "--json").out)["frames"][0].contains("touching"), false);
    expect_in("touching\n   20     6004", run_scb(stack + "--contacts all").out);
    const std::string crossing = run_scb(stack + "--contacts crossing").out;
    expect_in("\n   20        0 ", crossing);
    expect_in("\npairs: triangles that cross. 6,004 pairs that only touch: left out.\n", crossing);
    expect_in("\npairs: triangles that only touch. 0 pairs that cross: left out.\n",
              run_scb(stack + "--contacts touching").out);
    const json spheres =
        json::parse(run_scb("collide spheres-l1 --frames 100 --contacts crossing --json").out);
    EXPECT_EQ(spheres["contacts"], "crossing");
    EXPECT_EQ(
        spheres["frames"][0]["pairs"],
        json::parse(run_scb("collide spheres-l1 --frames 100 --json").out)["frames"][0]["pairs"]);
    for (const char* option : {"--first", "--max-pairs 5", "--levels 3"})
        expect_in("--contacts needs all pairs of triangles",
                  run_scb(stack + "--contacts all " + option).err);
    expect_in("--contacts some: give all, crossing, touching.",
              run_scb(stack + "--contacts some").err);
}

TEST(CollideCommand, QueriesPackedHierarchies) {
    const std::string spheres = "collide spheres-l1 --frames 0,100 ";
    const json reference = json::parse(run_scb(spheres + "--json").out),
               packed = json::parse(run_scb(spheres + "--layout quantized8 --leaf 3 --json").out);
    EXPECT_EQ(packed["layout"], "quantized8");
    EXPECT_EQ(packed["leaf"], 3);
    for (const char* of_reference : {"test", "descent"})
        EXPECT_FALSE(packed.contains(of_reference));
    for (const std::size_t i : {0u, 1u}) {
        const json &frame = packed["frames"][i], &there = reference["frames"][i];
        EXPECT_EQ(frame["pairs_hash"], there["pairs_hash"]);
        EXPECT_NE(frame["n_v"], there["n_v"]);
        for (const char* not_counted : {"n_u", "depth", "stages"})
            EXPECT_FALSE(frame.contains(not_counted)) << not_counted;
    }
    const ProgramRun first = run_scb(spheres + "--layout quantized8 --first");
    EXPECT_NE(first.out.find(", layout quantized8, at most 4 triangles in a leaf\n"),
              std::string::npos)
        << first.out;
    EXPECT_NE(first.out.find("\n  100        1 "), std::string::npos) << first.out;
    EXPECT_EQ(first.err, "");
    const std::string csv = run_scb(spheres + "--layout quantized8 --first --csv").out;
    EXPECT_NE(csv.find("\n0,0,"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",,,1\n100,1,"), std::string::npos) << csv;
    EXPECT_NE(run_scb(spheres + "--leaf 3").err.find("--leaf has no effect here"),
              std::string::npos);
}

TEST(CollideCommand, TakesTheNearestRotationOfAPoseWithFewDigits) {
    const std::string samples = std::string(SCB_SOURCE_DIR) + "/scenes/samples/",
                      meshes = "collide " + samples + "bracket.ply " + samples + "pin.obj ",
                      six = "--pose 0.866025,-0.5,0,1,0.5,0.866025,0,2,0,0,1,45 ",
                      exact =
                          "--pose 0.8660254037844386,-0.5,0,1,0.5,0.8660254037844386,0,2,0,0,1,45 ";
    const ProgramRun rough = run_scb(meshes + six + "--json"),
                     smooth = run_scb(meshes + exact + "--json");
    ASSERT_EQ(rough.status, 0) << rough.err;
    EXPECT_EQ(rough.err,
              "scb: the pose of pin is not quite a rotation; the nearest one is used, which "
              "changes its numbers by 3e-07 at most.\n");
    EXPECT_EQ(smooth.err, "");
    EXPECT_GT(json::parse(smooth.out)["frames"][0]["n_v"], 1);
    EXPECT_EQ(json::parse(rough.out)["frames"][0]["pairs_hash"],
              json::parse(smooth.out)["frames"][0]["pairs_hash"]);
    const ProgramRun refused = run_scb(meshes + six + "--exact-pose");
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("1e-9 is allowed"), std::string::npos) << refused.err;
    EXPECT_EQ(run_scb(meshes + exact + "--exact-pose").status, 0);
    // A scene file has the same rule.
    const TemporaryFolder folder;
    const std::string scene = folder.write(
        "s.json", R"({"scb_scene": 1, "name": "s", "models": [{"name": "m", "box": {}}],
            "bodies": [{"name": "A", "model": "m"}, {"name": "B", "model": "m",
            "pose": [0.866025, -0.5, 0, 0.5, 0.5, 0.866025, 0, 0, 0, 0, 1, 0]}]})");
    EXPECT_NE(run_scb("collide " + scene).err.find("the pose of B is not quite a rotation"),
              std::string::npos);
    EXPECT_EQ(run_scb("collide --exact-pose " + scene).status, 2);
}

TEST(CollideCommand, RefusesWhatMakesNoSense) {
    const TemporaryFolder folder;
    for (const auto& [arguments, part] : std::vector<std::pair<std::string, std::string>>{
             {"spheres-l1 --frames 500", "there is no frame 500"},
             {"spheres-l1 --frames 5:1", "names nothing"},
             {"spheres-l1 --frames x", "is not a whole number"},
             {"spheres-l1 --test gjk", "is not an overlap test"},
             {"spheres-l1 --test symmetric,extents", "one overlap test at a time"},
             {"spheres-l1 --volume scb,ball",
              "one of scb,ball,ritter,obb,scb2,aabb,aabb-exact,dop14,dop18,dop26,rss,capsule at a "
              "time"},
             {"spheres-l1 --threshold 2", "give a cosine from 0 to 1"},
             {"spheres-l1 --threshold nan", "give a cosine from 0 to 1"},
             {"spheres-l1 --descent up", "--descent up: give radius, area, volume or alternating"},
             {"spheres-l1 --layout flat", "'flat' is not a layout"},
             {"spheres-l1 --layout float8,float4", "give one layout"},
             {"spheres-l1 --layout float8 --leaf 5", "--leaf 5: give 1 to 4"},
             {"spheres-l1 --layout float8 --volume obb", "obb volumes have no packed layout"},
             {"spheres-l1 --layout float8 --levels 3", "--levels is of the reference only"},
             {"spheres-l1 --layout float8 --max-pairs 3", "--max-pairs is of the reference only"},
             {"spheres-l1 --layout float8 --test extents", "--test is of the reference only"},
             {"spheres-l1 --layout float8 --threshold 0.5", "--threshold is of the reference only"},
             {"spheres-l1 --layout float8 --descent area", "--descent is of the reference only"},
             {"spheres-l1 --layout float8 --bodies A,A", "packed queries are of two bodies"},
             {"spheres-l1 --bodies A", "give two bodies"},
             {"spheres-l1 --bodies A,C", "is not a body"},
             {"spheres-l1 --level 99", "have the levels 0 to"},
             {"spheres-l1 --max-pairs 0", "give at least 1"},
             {"spheres-l1 --max-pairs -1", "give at least 1"},
             {"spheres-l1 --level -1", "have the levels 0 to"},
             {"spheres-l1 --json --csv", "exclude each other"},
             {"spheres-l1 --max-pairs 010", "'010' is not a whole number"},
             {"spheres-l1 --level ''", "--levels: the value is empty"},
             {"spheres-l1 --margin ''", "--margin: the value is empty"},
             {"spheres-l1 --pairs-out -", "standard output"},
             {"spheres-l1 --pairs-out ''", "--pairs-out: the value is empty"},
             {"horses --models " + (folder / "nowhere"), "48485 vertices"}}) {
        const ProgramRun run = run_scb("collide " + arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
        EXPECT_EQ(lines(run.err).size(), 1u) << run.err;
    }
    const ProgramRun unwritable =
        run_scb("collide spheres-l1 --frames 100 --pairs-out " + (folder / "no/such/file.csv"));
    EXPECT_EQ(unwritable.status, 3);
    EXPECT_EQ(unwritable.out, "");
}

TEST(CollideCommand, TellsThePosesInJson) {
    const scenes::Scene scene = scenes::load_scene({"spheres-l1"});
    const json all = json::parse(run_scb("collide spheres-l1 --frames 100:300:100 --json").out),
               frame = all["frames"][0];
    const Pose pose = relative_pose(scenes::pose_at(scene.bodies[0].motion, 100),
                                    scenes::pose_at(scene.bodies[1].motion, 100));
    ASSERT_EQ(frame["pose"].size(), 12u);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            EXPECT_EQ(frame["pose"][static_cast<std::size_t>(4 * row + column)],
                      pose.rotation(row, column));
        EXPECT_EQ(frame["pose"][static_cast<std::size_t>(4 * row + 3)], pose.translation[row]);
    }
    // In the world, of the first and the last frame.
    ASSERT_EQ(all["poses"].size(), 2u);
    const Pose b = scenes::pose_at(scene.bodies[1].motion, 300);
    EXPECT_EQ(all["poses"]["300"]["B"][3], b.translation[0]);
    EXPECT_EQ(all["poses"]["300"]["B"][4], b.rotation(1, 0));
    EXPECT_EQ(all["poses"]["100"].size(), 2u);
}

TEST(CollideCommand, SaysWhichOptionsHaveNoEffect) {
    const std::string start = "collide spheres-l1 --frames 0 ";
    EXPECT_NE(
        run_scb(start + "--volume ball --test line8 --threshold 0.5").err.find("have no effect"),
        std::string::npos);
    EXPECT_NE(run_scb(start + "--threshold 0.5").err.find("--threshold has no effect"),
              std::string::npos);
    for (const char* volume : {"--volume scb2", "--volume obb"}) {
        const std::string note = run_scb(start + volume + " --threshold 0.5").err;
        EXPECT_EQ(
            note,
            "scb: --threshold has no effect: it is for slab cut balls with one slab (scb).\n");
    }
    EXPECT_EQ(run_scb(start + "--threshold 0.5 --test corrected").err, "");
    EXPECT_EQ(run_scb(start + "--volume ball").err, "");
}

TEST(CollideCommand, AnInterruptLeavesTheFinishedFrames) {
    const TemporaryFolder folder;
    const std::string file = folder / "pairs.csv", scene = folder / "endless.json";
    write_text(scene, endless_scene);
    const ProgramRun run =
        run_scb_interrupted("collide " + scene + " --csv --pairs-out " + file, has_computed);
    ASSERT_EQ(run.status, 130) << run.err;
    EXPECT_NE(run.err.find("of 1000000 frames are finished"), std::string::npos) << run.err;
    const std::vector<std::string> rows = lines(run.out), pairs = lines(file_text(file));
    ASSERT_GE(rows.size(), 2u);
    EXPECT_EQ(pairs[0], "frame,triangle_a,triangle_b");
    // Every finished frame has its pairs, which are always the same.
    const std::size_t finished = rows.size() - 1, each = (pairs.size() - 1) / finished;
    EXPECT_GT(each, 0u);
    EXPECT_EQ(pairs.size() - 1, each * finished);
    EXPECT_EQ(std::stoi(pairs.back()), static_cast<int>(finished) - 1);
}

// Sent to a file, the list and the table follow each other in it.
TEST(CollideCommand, ListsPairsToStandardOutputThatIsAFile) {
    const ProgramRun run = run_scb("collide spheres-l1 --frames 100 --csv --pairs-out /dev/stdout");
    EXPECT_EQ(run.status, 0) << run.err;
    const std::vector<std::string> text = lines(run.out);
    ASSERT_GT(text.size(), 3u);
    EXPECT_EQ(text[0], "frame,triangle_a,triangle_b");
    EXPECT_EQ(text[text.size() - 2].substr(0, 12), "frame,pairs,");
}

TEST(CollideCommand, DoesNotOverwriteWhatItReads) {
    const TemporaryFolder folder;
    const std::string mesh = folder / "m.off", bytes = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    write_text(mesh, bytes);
    const std::string scene = folder / "s.json";
    write_text(scene, R"({"scb_scene": 1, "name": "s", "models": [{"name": "m", "file": "m.off"}],
        "bodies": [{"name": "A", "model": "m"}, {"name": "B", "model": "m"}]})");
    for (const std::string& arguments :
         {"collide " + mesh + " " + mesh + " --pairs-out ", "collide " + scene + " --pairs-out ",
          "export " + scene + " --level 0 -o "}) {
        const ProgramRun run = run_scb(arguments + mesh);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_NE(run.err.find("which this command reads"), std::string::npos) << run.err;
        EXPECT_EQ(file_text(mesh), bytes);
    }
}

}  // namespace
}  // namespace scb::app
