#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "render/files/image_file.h"
#include "tests/app/program.h"
#include "tests/unless_sanitized.h"

namespace scb::app {
namespace {

using nlohmann::json;

/// A tetrahedron of this size, its lowest corner at (x, 0, 0).
std::string tetrahedron(double size, double x) {
    std::ostringstream obj;
    obj << "v " << x << " 0 0\nv " << x + size << " 0 0\nv " << x << " " << size << " 0\nv " << x
        << " 0 " << size << "\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    return obj.str();
}

json json_of(const std::string& arguments, const Surroundings& where = {}) {
    const ProgramRun run = run_scb("distance " + arguments + " --json", where);
    EXPECT_EQ(run.status, 0) << run.err;
    return json::parse(run.out);
}

class DistanceCommand : public testing::Test {
  protected:
    TemporaryFolder folder_;
    const Surroundings here_{folder_.path.string(), {}};
    void write(const std::string& name, const std::string& text) const {
        write_text(folder_.path / name, text);
    }
};

TEST_F(DistanceCommand, MeasuresTheGapBetweenTwoMeshes) {
    write("a.obj", tetrahedron(1, 0));
    write("b.obj", tetrahedron(1, 3));
    const json result = json_of("a.obj b.obj", here_), frame = result["frames"][0];
    EXPECT_EQ(result["query"], "distance");
    EXPECT_EQ(frame["distance"], 2.0);
    EXPECT_EQ(frame["signed_distance"], 2.0);
    EXPECT_EQ(frame["points"], json::parse("[[1.0,0.0,0.0],[3.0,0.0,0.0]]"));
    EXPECT_EQ(frame["inside"], json::array());
    EXPECT_EQ(result["least"]["distance"], 2.0);
    std::uint64_t sum = 0;
    for (const auto& [stage, count] : frame["stages"].items()) sum += count.get<std::uint64_t>();
    EXPECT_EQ(sum, frame["n_v"]);
}

TEST_F(DistanceCommand, IsNegativeInside) {
    write("a.obj", tetrahedron(100, -10));
    write("b.obj", tetrahedron(1, 3));
    // B is moved off the faces of A.
    const json frame = json_of("a.obj b.obj --pose 1,0,0,0,0,1,0,5,0,0,1,7", here_)["frames"][0];
    EXPECT_EQ(frame["distance"], 5.0);
    EXPECT_EQ(frame["signed_distance"], -5.0);
    EXPECT_EQ(frame["inside"][0]["body"], "b");
    EXPECT_EQ(frame["inside"][0]["in"], "a");
    // Without a face, A has no inside.
    std::string open = tetrahedron(100, -10);
    open.erase(open.rfind("f "));
    write("a.obj", open);
    const json not_judged =
        json_of("a.obj b.obj --pose 1,0,0,0,0,1,0,5,0,0,1,7", here_)["frames"][0];
    EXPECT_EQ(not_judged["distance"], 5.0);
    EXPECT_TRUE(not_judged["signed_distance"].is_null());
    EXPECT_TRUE(not_judged["inside"].is_null());
    EXPECT_NE(run_scb("distance a.obj b.obj --pose 1,0,0,0,0,1,0,5,0,0,1,7", here_)
                  .out.find("Whether b lies inside a is not judged: a is not closed."),
              std::string::npos);
}

TEST_F(DistanceCommand, VolumesOrdersAndSeedsAgree) {
    // Nested spheres take long.
    const std::string scene =
        unless_sanitized("spheres-l1 --frames 0,2,250,400", "spheres-l1 --frames 0,2,400");
    const json reference = json_of(scene)["frames"];
    std::set<std::uint64_t> works;
    for (const char* options :
         {"--volume obb", "--volume scb", "--order nearest", "--order depth-first", "--seed",
          "--split paper", "--descent alternating"}) {
        SCOPED_TRACE(options);
        const json frames = json_of(scene + " " + options)["frames"];
        for (std::size_t i = 0; i < frames.size(); ++i) {
            for (const char* key : {"distance", "signed_distance", "inside"})
                EXPECT_EQ(frames[i][key], reference[i][key]) << key;
            if (frames[i]["distance"] > 0) {
                EXPECT_EQ(frames[i]["triangles"], reference[i]["triangles"]);
                EXPECT_EQ(frames[i]["points"], reference[i]["points"]);
            }
        }
        works.insert(frames[1]["n_v"].get<std::uint64_t>());
    }
    EXPECT_GT(works.size(), 4u);
}

TEST_F(DistanceCommand, ListsTrianglesWithinATolerance) {
    const std::string scene = "spheres-l1 --frames 0,2";
    const json whole = json_of(scene)["frames"];
    const double nearest = whole[0]["distance"];
    // Whether a body is inside is judged, too, where triangles are near and do not intersect.
    const json nested = json_of("spheres-l1 --frames 100,250 --within 0.06")["frames"];
    EXPECT_TRUE(nested[0]["inside"].is_null());
    EXPECT_EQ(nested[1]["inside"][0]["body"], "A");
    EXPECT_GT(nested[1]["pairs"], 0);
    const json within =
        json_of(scene + " --within 0.06 --pairs-out " + (folder_.path / "near.csv").string());
    EXPECT_EQ(within["query"], "within");
    EXPECT_GT(within["frames"][0]["pairs"], 0);
    const std::vector<std::string> rows = lines(file_text(folder_.path / "near.csv"));
    EXPECT_EQ(rows[0], "frame,triangle_a,triangle_b");
    EXPECT_EQ(rows.size() - 1, within["frames"][0]["pairs"].get<std::size_t>() +
                                   within["frames"][1]["pairs"].get<std::size_t>());
    std::ostringstream below, at;
    below.precision(17);
    at.precision(17);
    below << " --within " << std::nextafter(nearest, 0);
    at << " --within " << nearest;
    EXPECT_EQ(json_of(scene + below.str())["frames"][0]["pairs"], 0);
    EXPECT_GT(json_of(scene + at.str())["frames"][0]["pairs"], 0);
    const json first = json_of(scene + at.str() + " --first")["frames"][0];
    EXPECT_EQ(first["within"], true);
    EXPECT_EQ(first["distance"], nearest);
    const json none = json_of(scene + below.str() + " --first")["frames"][0];
    EXPECT_EQ(none["within"], false);
    EXPECT_TRUE(none["distance"].is_null());
}

TEST_F(DistanceCommand, ExpectsAClearance) {
    for (const char* first : {"", " --first"}) {
        SCOPED_TRACE(first);
        const auto run = [first](const std::string& options) {
            return run_scb("distance spheres-l1 --expect-clear --within " + options + first);
        };
        const ProgramRun kept = run("0.001 --frames 0,2");
        EXPECT_EQ(kept.status, 0);
        EXPECT_NE(kept.out.find("\nClearance 0.001: kept.\n"), std::string::npos) << kept.out;
        const ProgramRun near = run("0.06 --frames 2");
        EXPECT_EQ(near.status, 1);
        EXPECT_NE(near.out.find("\nClearance 0.06: not kept.\n"), std::string::npos) << near.out;
        // No triangles are near where one sphere lies inside the other.
        const ProgramRun inside = run("1e-9 --frames 0,2,250,251");
        EXPECT_EQ(inside.status, 1);
        EXPECT_NE(inside.out.find("not kept in 2 of 4 frames, the first is frame 250."),
                  std::string::npos)
            << inside.out;
        const ProgramRun found = run("1e-9 --json --frames 0,250");
        EXPECT_EQ(found.status, 1);
        EXPECT_EQ(json::parse(found.out)["not_clear"], json::array({250}));
        EXPECT_EQ(json::parse(found.out)["clear"], false);
    }
    EXPECT_NE(run_scb("distance spheres-l1 --expect-clear --within 0.0012345678 --frames 0,2 --csv")
                  .err.find("Clearance 0.0012345678: kept."),
              std::string::npos);
    // Without the option, near triangles are a result like any other.
    EXPECT_EQ(run_scb("distance spheres-l1 --within 0.06 --frames 2").status, 0);
}

TEST_F(DistanceCommand, DoesNotJudgeTheClearanceInsideAnOpenMesh) {
    std::string open = tetrahedron(100, -10);
    open.erase(open.rfind("f "));
    write("open.obj", open);
    write("small.obj", tetrahedron(1, 3));
    const std::string meshes = "distance open.obj small.obj --within 0.01 --expect-clear ";
    for (const char* first : {"", " --first"}) {
        const ProgramRun run = run_scb(meshes + "--pose 1,0,0,0,0,1,0,5,0,0,1,7" + first, here_);
        EXPECT_EQ(run.status, 4) << run.out;
        EXPECT_NE(run.out.find("Whether small lies inside open is not judged"), std::string::npos)
            << run.out;
        EXPECT_NE(run.out.find("\nClearance 0.01: not judged."), std::string::npos) << run.out;
    }
    const ProgramRun far = run_scb(meshes + "--pose 1,0,0,900,0,1,0,0,0,0,1,0", here_);
    EXPECT_EQ(far.status, 0) << far.out;
    EXPECT_NE(far.out.find("Clearance 0.01: kept."), std::string::npos) << far.out;
}

TEST_F(DistanceCommand, LimitsAndErrorsAreKept) {
    const json exact = json_of("spheres-l1 --frames 2")["frames"][0];
    const json rough = json_of("spheres-l1 --frames 2 --relative-error 0.5")["frames"][0];
    EXPECT_GE(rough["distance"], exact["distance"]);
    EXPECT_LE(rough["distance"].get<double>(), 1.5 * exact["distance"].get<double>());
    EXPECT_LT(rough["n_v"], exact["n_v"]);
    const json none = json_of("spheres-l1 --frames 2 --limit 0.001");
    EXPECT_TRUE(none["frames"][0]["distance"].is_null());
    EXPECT_FALSE(none.contains("least"));
}

TEST_F(DistanceCommand, SaysWhereBodiesAreNearest) {
    const std::string text = run_scb("distance spheres-l1 --frames 0,2,250").out;
    EXPECT_NE(text.find("A inside B"), std::string::npos) << text;
    EXPECT_NE(text.find("Least distance: "), std::string::npos) << text;
    EXPECT_NE(text.find("In contact: in no frame, of those queried."), std::string::npos) << text;
    const std::string near = run_scb("distance spheres-l1 --frames 0:4 --within 0.05").out;
    EXPECT_NE(near.find("At most 0.05 apart: frames 1 to 4.\n"), std::string::npos) << near;
}

TEST_F(DistanceCommand, NamesBodiesOfSeveralPairs) {
    write("scene.json", R"({"scb_scene": 1, "name": "nuts", "models": [
        {"name": "large", "icosphere": {"subdivisions": 2, "radius": 1}},
        {"name": "small", "icosphere": {"subdivisions": 1, "radius": 0.2}}],
        "bodies": [{"name": "left", "model": "large"},
                   {"name": "right", "model": "large", "position": [3, 0, 0]},
                   {"name": "nut, M3", "model": "small"}]})");
    const json result = json_of("scene.json", here_);
    const json& queries = result["frames"][0]["queries"];
    ASSERT_EQ(queries.size(), 3u);
    EXPECT_EQ(queries[1]["bodies"], json::parse(R"(["left", "nut, M3"])"));
    EXPECT_LT(queries[1]["signed_distance"], 0);
    EXPECT_EQ(result["least"]["bodies"], queries[1]["bodies"]);
    EXPECT_EQ(result["least"]["distance"], queries[1]["distance"]);
    EXPECT_NE(run_scb("distance scene.json", here_).out.find("left and right"), std::string::npos);
}

TEST_F(DistanceCommand, NamesTheBodiesOfThePairThatIsInside) {
    write("three.json", R"({"scb_scene": 1, "name": "three", "models": [
        {"name": "large", "icosphere": {"subdivisions": 1, "radius": 2}},
        {"name": "small", "icosphere": {"subdivisions": 1, "radius": 1}}],
        "bodies": [{"name": "A", "model": "large"}, {"name": "B", "model": "small"},
                   {"name": "C", "model": "small", "position": [9, 0, 0]}]})");
    const std::string text = run_scb("distance three.json", here_).out;
    EXPECT_NE(text.find("B lies inside A."), std::string::npos) << text;
    EXPECT_EQ(text.find("C lies"), std::string::npos) << text;
}

TEST_F(DistanceCommand, NamesTheLeastDistanceOfBodiesApartWhereOthersMeet) {
    const std::string text = run_scb("distance spheres-l1 --frames 0,100").out;
    EXPECT_NE(text.find("\nLeast distance: 0 in frame 100"), std::string::npos) << text;
    EXPECT_NE(text.find("\nLeast distance of bodies apart: "), std::string::npos) << text;
    const std::string apart = run_scb("distance spheres-l1 --frames 0,2").out;
    EXPECT_EQ(apart.find("bodies apart"), std::string::npos) << apart;
}

TEST_F(DistanceCommand, TableAndCsvAgreeWithJson) {
    const std::string scene = "spheres-l1 --frames 0,2";
    const json frames = json_of(scene)["frames"];
    const std::vector<std::string> csv = lines(run_scb("distance " + scene + " --csv").out);
    ASSERT_EQ(csv.size(), 3u);
    EXPECT_TRUE(csv[0].starts_with("frame,distance,triangle_a,triangle_b,point_a_x"));
    for (std::size_t i = 0; i < 2; ++i) {
        std::istringstream row(csv[1 + i]);
        std::string frame, distance, a, b;
        for (std::string* cell : {&frame, &distance, &a, &b}) std::getline(row, *cell, ',');
        EXPECT_EQ(std::stod(distance), frames[i]["distance"].get<double>());
        EXPECT_EQ(a, frames[i]["triangles"][0].dump());
        EXPECT_EQ(b, frames[i]["triangles"][1].dump());
    }
}

TEST_F(DistanceCommand, ProvesEachDistance) {
    const std::string scene = unless_sanitized("spheres-l1 --frames 0,2,100,250 --prove",
                                               "spheres-l1 --frames 0,2,100,101 --prove");
    for (const json& frame : json_of(scene)["frames"]) {
        const json& proof = frame["proof"];
        EXPECT_EQ(proof["certified"], true);
        const double distance = frame["distance"], lower = proof["lower"], upper = proof["upper"];
        EXPECT_NEAR(lower, distance, 1e-9 * distance + 1e-14);
        EXPECT_NEAR(upper, distance, 1e-9 * distance + 1e-14);
        EXPECT_LE(lower, upper);
        EXPECT_EQ(proof["directions"] == 0, distance == 0);
    }
    const std::string text = run_scb("distance " + scene).out;
    EXPECT_NE(text.find("Proven: 4 of 4 distances"), std::string::npos) << text;
    EXPECT_NE(lines(run_scb("distance " + scene + " --csv").out)[0].find(",lower,upper,certified,"),
              std::string::npos);
}

TEST_F(DistanceCommand, PlotsDistancesOverFrames) {
    const std::string out = (folder_.path / "plot").string();
    const ProgramRun run =
        run_scb("distance spheres-l1 --frames 0:10 --svg --size 640x360 -o " + out);
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string name = out + "/spheres-l1_distance_frames-0-to-10_size-640x360.";
    EXPECT_EQ(render::read_png(name + "png").width, 640);
    const std::string svg = file_text(name + "svg");
    EXPECT_NE(svg.find("in contact"), std::string::npos);
    EXPECT_NE(svg.find("distance, in units of the mesh"), std::string::npos);
}

TEST_F(DistanceCommand, RefusesOptionsWithoutMeaning) {
    const auto error = [](const std::string& options) {
        const ProgramRun run = run_scb("distance spheres-l1 " + options);
        EXPECT_EQ(run.status, 2) << options;
        EXPECT_EQ(run.out, "");
        return run.err;
    };
    EXPECT_NE(error("--first").find("--within"), std::string::npos);
    EXPECT_NE(error("--expect-clear").find("--within"), std::string::npos);
    EXPECT_NE(error("--pairs-out x.csv").find("--within"), std::string::npos);
    EXPECT_NE(error("--within -1").find("0 or more"), std::string::npos);
    EXPECT_NE(error("--within nan").find("0 or more"), std::string::npos);
    EXPECT_NE(error("--within 1 --relative-error 0.1").find("--relative-error"), std::string::npos);
    EXPECT_NE(error("--relative-error -0.1").find("0 or more"), std::string::npos);
    EXPECT_NE(error("--limit nan").find("0 or more"), std::string::npos);
    EXPECT_NE(error("--prove --within 1").find("--within"), std::string::npos);
    EXPECT_NE(error("--prove --relative-error 0.1").find("--relative-error"), std::string::npos);
    EXPECT_NE(error("--within 1 -o plots").find("-o"), std::string::npos);
    EXPECT_NE(error("--json --csv").find("--csv"), std::string::npos);
    EXPECT_NE(error("--bodies A,A").find("name two bodies"), std::string::npos);
    EXPECT_NE(error("--order best").find("depth-first"), std::string::npos);
}

}  // namespace
}  // namespace scb::app
