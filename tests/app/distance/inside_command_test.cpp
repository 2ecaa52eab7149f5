#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/answer_table.h"
#include "tests/app/program.h"
#include "tests/unless_sanitized.h"

namespace scb::app {
namespace {

using nlohmann::json;

const char* const cube =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

class InsideCommand : public testing::Test {
  protected:
    TemporaryFolder folder_;
    const Surroundings here_{folder_.path.string(), {}};
    void write(const std::string& name, const std::string& text) const {
        write_text(folder_.path / name, text);
    }
    json answers(const std::string& mesh) const {
        const ProgramRun run = run_scb("inside " + mesh + " --points points.csv --json", here_);
        EXPECT_EQ(run.status, 0) << run.err;
        return json::parse(run.out);
    }
};

TEST_F(InsideCommand, SaysWhereEachPointIs) {
    write("cube.obj", cube);
    write("points.csv", "x,y,z\n0.5,0.5,0.25\n# a comment\n\n2 0.5 0.5\n1;1;1\n");
    const json result = answers("cube.obj"), &points = result["points"];
    ASSERT_EQ(points.size(), 3u);
    EXPECT_EQ(points[0]["answer"], "in");
    EXPECT_EQ(points[0]["distance"], 0.25);
    EXPECT_EQ(points[0]["signed_distance"], -0.25);
    EXPECT_EQ(points[0]["closest"], json::parse("[0.5,0.5,0.0]"));
    EXPECT_EQ(points[1]["answer"], "out");
    EXPECT_EQ(points[1]["signed_distance"], 1.0);
    EXPECT_EQ(points[2]["answer"], "on");
    EXPECT_EQ(points[2]["distance"], 0.0);
    EXPECT_EQ(result["in"], 1);
    const std::string text = run_scb("inside cube.obj --points points.csv", here_).out;
    EXPECT_NE(text.find("3 points: 1 in, 1 out, 1 on the surface."), std::string::npos) << text;
    EXPECT_EQ(lines_of(run_scb("inside cube.obj --points points.csv --csv", here_).out), 4u);
}

TEST_F(InsideCommand, DoesNotJudgeAnOpenMesh) {
    std::string open = cube;
    open.erase(open.rfind("f "));
    write("open.obj", open);
    write("points.csv", "0.5 0.5 0.25\n");
    const json result = answers("open.obj");
    EXPECT_EQ(result["closed"], false);
    EXPECT_TRUE(result["points"][0]["answer"].is_null());
    EXPECT_TRUE(result["points"][0]["signed_distance"].is_null());
    EXPECT_EQ(result["points"][0]["distance"], 0.25);
    EXPECT_NE(run_scb("inside open.obj --points points.csv", here_).out.find("not judged"),
              std::string::npos);
}

TEST_F(InsideCommand, RefusesFilesWithoutPoints) {
    write("cube.obj", cube);
    const auto error = [this](const std::string& points) {
        write("points.csv", points);
        const ProgramRun run = run_scb("inside cube.obj --points points.csv", here_);
        EXPECT_EQ(run.status, 2) << points;
        EXPECT_EQ(run.out, "");
        return run.err;
    };
    EXPECT_NE(error("").find("points.csv: it has no points"), std::string::npos);
    EXPECT_NE(error("x,y,z\n").find("it has no points"), std::string::npos);
    EXPECT_NE(error("1,2\n").find("line 1: it has 2 columns"), std::string::npos);
    EXPECT_NE(error("1,2,3\n1,2,nan\n").find("line 2: 'nan'"), std::string::npos);
    EXPECT_NE(error("1,2,3\nx,y,z\n").find("line 2: 'x'"), std::string::npos);
    EXPECT_NE(error("\"1\",\"2\",\"3\"\n").find("line 1: '\"1\"'"), std::string::npos);
    EXPECT_NE(error("a b\n1,2,3\n").find("the header before has 2 columns"), std::string::npos);
    EXPECT_NE(error("1,2,1e300\n").find("line 1: '1e300'"), std::string::npos);
    const ProgramRun two = run_scb("inside spheres-l1 --points points.csv", here_);
    EXPECT_EQ(two.status, 2);
    EXPECT_NE(two.err.find("2 bodies"), std::string::npos) << two.err;
}

TEST_F(InsideCommand, AgreesWithRecordedAnswers) {
    if (!has_model_file("horse.ply", "points inside of real meshes")) GTEST_SKIP();
    AnswerTable table("inside.tsv");
    std::map<std::string, std::string> points;
    std::map<std::string, std::vector<std::pair<std::string, double>>> expected;
    while (table.next()) {
        const std::string mesh = table.text("mesh");
        points[mesh] += table.text("x") + "," + table.text("y") + "," + table.text("z") + "\n";
        expected[mesh].emplace_back(table.text("answer"), table.number("distance"));
    }
    int checked = 0;
    for (const auto& [mesh, text] : points) {
        const std::filesystem::path file = models_folder() / (mesh + ".ply");
        if (std::filesystem::file_size(file) > unless_sanitized(400u, 60u) * 1000) continue;
        SCOPED_TRACE(mesh);
        write("points.csv", text);
        const json answers = this->answers(file.string())["points"];
        ASSERT_EQ(answers.size(), expected[mesh].size());
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const auto& [side, distance] = expected[mesh][i];
            EXPECT_EQ(answers[i]["answer"], side) << i;
            EXPECT_NEAR(answers[i]["distance"].get<double>(), distance, 1e-8 * distance + 1e-15)
                << i;
            ++checked;
        }
    }
    EXPECT_GE(checked, unless_sanitized(1000, 400));
}

}  // namespace
}  // namespace scb::app
