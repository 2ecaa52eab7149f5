#include "scenes/scene/raw_pairs.h"

#include <gtest/gtest.h>

#include "scb/error.h"

namespace scb::scenes {
namespace {

std::string refusal_of(const std::string& text) {
    try {
        parse_raw_pairs(text, "pairs.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string balls(const std::string& radius, const std::string& x) {
    return R"([{"a": {"center": [0, 0, 0], "radius": )" + radius + R"(}, "b": {"center": [)" + x +
           R"(, 0, 0], "radius": )" + radius + "}}]";
}

// Their squares would vanish, and with them the distances.
TEST(RawPairs, RefuseLengthsWhoseSquaresVanish) {
    EXPECT_EQ(refusal_of(balls("1e-170", "5e-170")),
              "pairs.json: [0].a.radius: 1e-170 is too small; at least 1e-60, or 0.");
    EXPECT_EQ(refusal_of(R"({"a": {"center": [0, 0, 0], "radius": 1, "normal": [0, 0, 1],
                                "e": 0, "f": 0},
                          "b": {"center": [0, 0, 0], "radius": 1e-61, "normal": [0, 0, 1],
                                "e": 0, "f": 0}})"),
              "pairs.json: b.radius: 1e-61 is too small; at least 1e-60, or 0.");
    const std::string axes = R"("axes": [[1, 0, 0], [0, 1, 0], [0, 0, 1]])";
    EXPECT_EQ(refusal_of(R"({"a": {"center": [0, 0, 0], )" + axes + R"(, "half": [1, 1e-100, 0]},
                          "b": {"center": [0, 0, 0], )" +
                         axes + R"(, "half": [1, 1, 1]}})"),
              "pairs.json: a.half[1]: 1e-100 is too small; at least 1e-60, or 0.");
    EXPECT_EQ(refusal_of(balls("0", "5e-170")),
              "pairs.json: [0].b.center: the two points are 5e-170 apart; at least 1e-60, or 0.");
}

TEST(RawPairs, AcceptPointsAndTheSmallestLengths) {
    EXPECT_EQ(refusal_of(balls("0", "0")), "");
    EXPECT_EQ(refusal_of(balls("0", "1e-60")), "");
    EXPECT_EQ(refusal_of(balls("1e-60", "5e-170")), "");
    EXPECT_EQ(refusal_of(balls("1e-60", "5e-60")), "");
}

}  // namespace
}  // namespace scb::scenes
