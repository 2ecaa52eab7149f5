#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

const std::string sliding_pin =
    "collide " + std::string(SCB_SOURCE_DIR) + "/scenes/samples/bracket.json ";

void expect_part(const std::string& part, const std::string& whole) {
    EXPECT_NE(whole.find(part), std::string::npos) << whole;
}

TEST(ContactIntervals, AreTheFramesInContact) {
    const std::string text = run_scb(sliding_pin).out;
    EXPECT_TRUE(text.ends_with("\nIn contact: frames 82 to 99.\n")) << text;
    const json all = json::parse(run_scb(sliding_pin + "--json").out);
    EXPECT_EQ(all["contact_intervals"],
              json::parse(R"([{"bodies": ["bracket", "pin"], "frames": [[82, 99]]}])"));
    EXPECT_EQ(json::parse(run_scb(sliding_pin + "--frames 0:9 --json").out)["contact_intervals"],
              json::array());
    expect_part("\nIn contact: frames 85 to 95, of those queried.\n",
                run_scb(sliding_pin + "--frames 65:95:10").out);
    expect_part("\nIn contact: frame 82.\n", run_scb(sliding_pin + "--frames 80:82 --first").out);
    for (const char* none : {"--frames 85", "--frames 0:9", "--frames 82:85 --levels 3"})
        EXPECT_EQ(run_scb(sliding_pin + none).out.find("In contact"), std::string::npos) << none;
}

TEST(ContactIntervals, AreOfTheChosenContactsAndOfEachPairOfBodies) {
    const TemporaryFolder folder;
    // B crosses A, leaves it, and crosses it again; C touches A in the first frames.
    folder.write("b.csv",
                 "0.5 0.2 0.1 0 0 0 1\n0.5 0.2 0.1 0 0 0 1\n5 0 0 0 0 0 1\n0.5 0.2 0.1 0 0 0 1\n");
    folder.write("c.csv", "-1 0 0 0 0 0 1\n-1 0 0 0 0 0 1\n-9 0 0 0 0 0 1\n-9 0 0 0 0 0 1\n");
    const std::string start = R"({"scb_scene": 1, "name": "s", "models": [{"name": "m", "box": {}}],
        "bodies": [{"name": "A", "model": "m"}, {"name": "B", "model": "m", "poses": "b.csv"})",
                      command = "collide " + folder.write("two.json", start + "]}") + " ";
    expect_part("\nIn contact: frames 0 to 1, 3.\n", run_scb(command).out);
    const std::string three = "collide " +
                              folder.write("three.json", start + R"(, {"name": "C", "model": "m",
                                  "poses": "c.csv"}]})") +
                              " ";
    expect_part("\nIn contact: A and B in frames 0 to 1, 3; A and C in frames 0 to 1.\n",
                run_scb(three).out);
    EXPECT_EQ(json::parse(run_scb(three + "--json --contacts crossing").out)["contact_intervals"],
              json::parse(R"([{"bodies": ["A", "B"], "frames": [[0, 1], [3, 3]]}])"));
    expect_part("\nCrossing: A and B in frames 0 to 1, 3.\n",
                run_scb(three + "--contacts crossing").out);
}

TEST(ContactIntervals, NameTheFirstAndCountTheRest) {
    const TemporaryFolder folder;
    std::string log;
    for (int i = 0; i < 25; ++i) log += "0.5 0 0 0 0 0 1\n5 0 0 0 0 0 1\n";
    folder.write("b.csv", log);
    const std::string scene = folder.write(
        "s.json", R"({"scb_scene": 1, "name": "s", "models": [{"name": "m", "box": {}}], "bodies":
            [{"name": "A", "model": "m"}, {"name": "B", "model": "m", "poses": "b.csv"}]})");
    expect_part(", 36, 38 and 5 more intervals.\n", run_scb("collide " + scene).out);
}

}  // namespace
}  // namespace scb::app
