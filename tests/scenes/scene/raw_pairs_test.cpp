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

std::string two_slabs(const std::string& second) {
    const std::string volume =
        R"({"center": [0, 0, 0], "radius": 2, "slabs": [{"normal": [0, 0, 1], "e": 1, "f": -1}, )" +
        second + "]}";
    return R"({"a": )" + volume + R"(, "b": )" + volume + "}";
}

TEST(RawPairs, ReadTwoSlabs) {
    const auto pairs =
        parse_raw_pairs(two_slabs(R"({"normal": [1, 0, 1e-7], "e": 3, "f": -0.5})"), "pairs.json");
    ASSERT_EQ(pairs.size(), 1u);
    const auto& pair = std::get<RawPair<Scb2>>(pairs[0]);
    EXPECT_TRUE(is_well_formed(pair.a) && is_well_formed(pair.b));
    EXPECT_EQ(pair.a.slabs[0].e, 1);
    EXPECT_EQ(pair.a.slabs[1].e, 2);  // the ball's pole
    EXPECT_EQ(pair.a.slabs[1].f, -0.5);
    ASSERT_EQ(pair.notes.size(), 4u);
    EXPECT_EQ(pair.notes[1],
              "a.slabs[1].normal has the product 1e-07 with the first normal and was turned to a "
              "right angle.");
}

TEST(RawPairs, RefuseTwoSlabsThatAreNone) {
    EXPECT_EQ(refusal_of(two_slabs(R"({"normal": [0.6, 0, 0.8], "e": 1, "f": -1})")),
              "pairs.json: a.slabs[1].normal: this is not at right angles to the first normal: "
              "their product is 0.8; give two that are.");
    EXPECT_EQ(refusal_of(two_slabs(R"({"normal": [1, 0, 0], "e": 1, "f": 0.5})")),
              "pairs.json: a.slabs[1].f: f = 0.5 is above the center, which each of two slabs must "
              "hold.");
    EXPECT_EQ(refusal_of(two_slabs(R"({"normal": [1, 0, 0], "e": -1, "f": -1.5})")),
              "pairs.json: a.slabs[1].e: e = -1 is below the center, which each of two slabs must "
              "hold.");
    EXPECT_EQ(refusal_of(R"({"a": {"center": [0, 0, 0], "radius": 1, "slabs": []},
                             "b": {"center": [0, 0, 0], "radius": 1, "slabs": []}})"),
              "pairs.json: a.slabs: expected two slabs, found [].");
    EXPECT_EQ(refusal_of(R"({"a": {"center": [0, 0, 0], "radius": 1},
                             "b": {"center": [0, 0, 0], "radius": 1, "slabs": []}})"),
              "pairs.json: a is a ball and b is a ball cut by two slabs; give two of one kind.");
}

}  // namespace
}  // namespace scb::scenes
