#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

const char* const moved_cube =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

class MotionCommand : public testing::Test {
  protected:
    TemporaryFolder folder_;
    const Surroundings here_{folder_.path.string(), {}};

    void SetUp() override { write_text(folder_.path / "cube.obj", moved_cube); }
    json motion(const std::string& poses, const std::string& options = "") const {
        write_text(folder_.path / "log.csv", poses);
        const ProgramRun run =
            run_scb("motion cube.obj cube.obj --poses log.csv --json " + options, here_);
        EXPECT_EQ(run.status, 0) << run.err;
        return json::parse(run.out);
    }
};

TEST_F(MotionCommand, FindsTheContactThatBothFramesMiss) {
    // Through the first cube, from one side to the other: faces meet at x = 1 and at x = -1.
    const json result = motion("4 0.1 0.2 0 0 0 1\n-4 0.1 0.2 0 0 0 1\n", "--tolerance 1e-6");
    const json& step = result["steps"][0];
    EXPECT_EQ(step["contact"], "contact");
    const double time = 3.0 / 8;
    EXPECT_LE(step["not_before"], time);
    EXPECT_GE(step["at_latest"], time);
    EXPECT_LE(step["at_latest"].get<double>() - step["not_before"].get<double>(), 1e-6);
    EXPECT_EQ(result["jumped"], json::parse("[[0,1]]"));
    EXPECT_EQ(result["first_contact"]["at_latest"], step["at_latest"]);
    const std::string text = run_scb("motion cube.obj cube.obj --poses log.csv", here_).out;
    EXPECT_NE(text.find("the bodies touch between 0 and 1, and are apart at both"),
              std::string::npos)
        << text;
}

TEST_F(MotionCommand, TurnsBodiesAboutTheirOrigin) {
    // A half turn about z at x = 2.2: a corner of the cube sweeps over the first one.
    const json turned = motion("2.2 0.1 0 0 0 0 1\n2.2 0.1 0 0 0 0.99999 0.00447211359\n");
    EXPECT_EQ(turned["steps"][0]["contact"], "contact");
    EXPECT_EQ(
        motion("2.5 0.1 0 0 0 0 1\n2.5 0.1 0 0 0 0.99999 0.00447211359\n")["steps"][0]["contact"],
        "none");
}

TEST_F(MotionCommand, SaysNothingOfBodiesThatAreTooNear) {
    // The cube slides along the first one, at a gap below the rounding of numbers.
    const json step =
        motion("1.0000000000000002 3 0 0 0 0 1\n1.0000000000000002 -3 0 0 0 0 1\n")["steps"][0];
    EXPECT_EQ(step["contact"], "undecided");
    EXPECT_LT(step["least_measured"], 1e-15);
    EXPECT_LE(step["not_before"], 1.0 / 3);
    EXPECT_NE(run_scb("motion cube.obj cube.obj --poses log.csv", here_)
                  .out.find("too near for the tolerance"),
              std::string::npos);
}

TEST_F(MotionCommand, RefusesOneFrameAndWrongTolerances) {
    const auto error = [](const std::string& options) {
        const ProgramRun run = run_scb("motion spheres-l1 " + options);
        EXPECT_EQ(run.status, 2) << options;
        return run.err;
    };
    EXPECT_NE(error("--frames 3").find("at least two frames"), std::string::npos);
    EXPECT_NE(error("--frames 0,1 --tolerance 0").find("--tolerance 0"), std::string::npos);
    EXPECT_NE(error("--frames 0,1 --tolerance nan").find("--tolerance"), std::string::npos);
    EXPECT_NE(error("--frames 0,1 --bodies A,A").find("name two bodies"), std::string::npos);
}

}  // namespace
}  // namespace scb::app
