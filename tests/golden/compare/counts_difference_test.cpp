#include "golden/compare/counts_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <random>
#include <string>

namespace scb::golden {

static void PrintTo(const CountChange& change, std::ostream* out) {
    const auto side = [](const std::optional<std::int64_t>& value, const std::string& text) {
        return value ? std::to_string(*value) : text.empty() ? "none" : text;
    };
    *out << change.place << ": " << side(change.before, change.before_text) << " -> "
         << side(change.after, change.after_text);
}

namespace {

using nlohmann::json;
using Changes = std::vector<CountChange>;

Changes difference(const char* before, const char* after) {
    return counts_difference(json::parse(before), json::parse(after));
}

TEST(CountsDifference, IsEmptyForEqualTrees) {
    for (const char* tree :
         {"{}", "[]", "null", "7", R"({"a": {"b": [1, 2, {"c": -3}]}, "d": {}})"})
        EXPECT_EQ(difference(tree, tree), Changes{}) << tree;
}

TEST(CountsDifference, DistancesMayDifferByTheBoundOfTheBaseline) {
    const auto with = [](double distance, double bound) {
        return json{{"frames", {{"20", {{"distance", {{"value", distance}, {"bound", bound}}}}}}}};
    };
    const double bound = 0x1p-50;
    const json before = with(2, bound);
    for (const double near : {2.0, 2 + bound, 2 - bound})
        EXPECT_EQ(counts_difference(before, with(near, 0)), Changes{}) << near;
    for (const double far : {2 + 2 * bound, 2 - 2 * bound, 3.0, 1e300}) {
        const Changes changes = counts_difference(before, with(far, 10));
        ASSERT_EQ(changes.size(), 1u) << far;
        EXPECT_EQ(changes[0].place, "frames/20/distance");
        EXPECT_EQ(changes[0].before_text, "2.0");
        EXPECT_EQ(changes[0].after_text, json(far).dump());
        EXPECT_EQ(changes[0].bound, json(bound).dump());
    }
    EXPECT_EQ(counts_difference(with(0, 0), with(0, 0)), Changes{});
    EXPECT_EQ(counts_difference(with(0, 0), with(5e-324, 0)).size(), 1u);
    // A distance that is gone or new.
    const json none = json::parse(R"({"frames": {"20": {}}})");
    EXPECT_FALSE(counts_difference(before, none).empty());
    EXPECT_FALSE(counts_difference(none, before).empty());
}

TEST(CountsDifference, NamesAChangedCountByItsPlace) {
    const char* before = R"({"frames": {"100": {"stages": {"ball-slab": 4, "overlapping": 9}}}})";
    const char* after = R"({"frames": {"100": {"stages": {"ball-slab": 5, "overlapping": 9}}}})";
    EXPECT_EQ(difference(before, after), (Changes{{"frames/100/stages/ball-slab", 4, 5}}));
}

TEST(CountsDifference, ListsWhatAppearedWhereItBelongs) {
    EXPECT_EQ(
        difference(R"({"b": 1, "c": 2, "d": {"x": 3}})", R"({"a": 7, "b": 8, "d": {"y": 9}})"),
        (Changes{{"a", {}, 7}, {"b", 1, 8}, {"c", 2, {}}, {"d/x", 3, {}}, {"d/y", {}, 9}}));
}

TEST(CountsDifference, SortsFramesAndDepthsAsNumbers) {
    EXPECT_EQ(difference(R"({"n_v": 1, "10": {"2": 1, "10": 2}, "9": 3, "01": 4})",
                         R"({"n_v": 2, "10": {"2": 2, "10": 3, "9": 4}, "9": 4, "01": 5,
                             "11": {"10": 1, "7": 2}})"),
              (Changes{{"9", 3, 4},
                       {"10/2", 1, 2},
                       {"10/9", {}, 4},
                       {"10/10", 2, 3},
                       {"11/7", {}, 2},
                       {"11/10", {}, 1},
                       {"01", 4, 5},
                       {"n_v", 1, 2}}));
}

TEST(CountsDifference, TellsAHashFromACount) {
    EXPECT_TRUE(is_hash({"frames/0/pairs_hash", 1, 2}));
    EXPECT_FALSE(is_hash({"frames/0/pairs", 1, 2}));
}

TEST(CountsDifference, WalksListsByIndex) {
    EXPECT_EQ(difference("[1, [2, 3], 4]", "[1, [2]]"), (Changes{{"1/1", 3, {}}, {"2", 4, {}}}));
    EXPECT_EQ(difference("[1]", R"([2, {"a": 3}, 4])"),
              (Changes{{"0", 1, 2}, {"1/a", {}, 3}, {"2", {}, 4}}));
}

TEST(CountsDifference, IsExactBeyondWhatADoubleHolds) {
    EXPECT_EQ(difference("[9007199254740993, 9223372036854775807, -9223372036854775808]",
                         "[9007199254740992, 9223372036854775806, -9223372036854775807]"),
              (Changes{{"0", 9007199254740993, 9007199254740992},
                       {"1", std::numeric_limits<std::int64_t>::max(),
                        std::numeric_limits<std::int64_t>::max() - 1},
                       {"2", std::numeric_limits<std::int64_t>::min(),
                        std::numeric_limits<std::int64_t>::min() + 1}}));
    EXPECT_EQ(difference("18446744073709551615", "18446744073709551614"),
              (Changes{{"", {}, {}, "18446744073709551615", "18446744073709551614"}}));
}

TEST(CountsDifference, ComparesOneIntegerHeldInTwoWays) {
    EXPECT_EQ(counts_difference(json(7u), json(7)), Changes{});
    EXPECT_EQ(counts_difference(json(std::uint64_t{18446744073709551615u}), json(-1)),
              (Changes{{"", {}, -1, "18446744073709551615", ""}}));
}

TEST(CountsDifference, ComparesOtherLeavesAsText) {
    EXPECT_EQ(difference(R"({"a": 0.5, "b": "scb", "c": null, "d": true, "e": 1, "f": 0.1})",
                         R"({"a": 0.25, "b": "obb", "c": 0, "d": false, "e": 1.0, "f": 0.1})"),
              (Changes{{"a", {}, {}, "0.5", "0.25"},
                       {"b", {}, {}, "\"scb\"", "\"obb\""},
                       {"c", {}, 0, "null", ""},
                       {"d", {}, {}, "true", "false"},
                       {"e", 1, {}, "", "1.0"}}));
    EXPECT_EQ(counts_difference(json("\xff"), json("\xfe")).size(), 1u) << "not UTF-8";
}

TEST(CountsDifference, TellsALeafFromAnObjectAndAnObjectFromAList) {
    EXPECT_EQ(difference(R"({"a": 5})", R"({"a": {"x": 1, "y": 2}})"),
              (Changes{{"a", 5, {}}, {"a/x", {}, 1}, {"a/y", {}, 2}}));
    EXPECT_EQ(difference(R"({"a": {"x": 1}})", R"({"a": 5})"),
              (Changes{{"a/x", 1, {}}, {"a", {}, 5}}));
    EXPECT_EQ(difference(R"({"0": 1})", "[1]"), (Changes{{"0", 1, {}}, {"0", {}, 1}}));
}

TEST(CountsDifference, TellsAnEmptyObjectFromNothing) {
    EXPECT_EQ(difference(R"({"a": {}})", "{}"), (Changes{{"a", {}, {}, "{}", ""}}));
    EXPECT_EQ(difference("{}", R"({"a": []})"), (Changes{{"a", {}, {}, "", "[]"}}));
    EXPECT_EQ(difference(R"({"a": {}})", R"({"a": []})"), (Changes{{"a", {}, {}, "{}", "[]"}}));
    EXPECT_EQ(difference(R"({"a": {}})", R"({"a": {"b": 1}})"), (Changes{{"a/b", {}, 1}}));
    EXPECT_EQ(difference("[[1]]", "[[]]"), (Changes{{"0/0", 1, {}}}));
}

TEST(CountsDifference, HasAPlaceOfItsOwnForEveryKey) {
    EXPECT_EQ(difference(R"({"a/b": 1, "a": {"b": 2}, "c~1d": 3})",
                         R"({"a/b": 4, "a": {"b": 5}, "c~1d": 6})"),
              (Changes{{"a/b", 2, 5}, {"a~1b", 1, 4}, {"c~01d", 3, 6}}));
}

// A tree of the few things that trees can go wrong with.
json random_tree(std::mt19937& random, int depth) {
    const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
    const int kind = below(depth > 0 ? 6 : 3);
    if (kind == 0) return below(3);
    if (kind == 1) return below(2) ? json(0.5) : json("0");
    if (kind == 2) return below(2) ? json::object() : json::array();
    json tree = kind == 3 ? json::array() : json::object();
    for (int i = below(4); i > 0; --i) {
        if (tree.is_array())
            tree.push_back(random_tree(random, depth - 1));
        else
            tree[std::string(1, "01a/~"[below(5)])] = random_tree(random, depth - 1);
    }
    return tree;
}

TEST(CountsDifference, IsEmptyOnlyForEqualTreesAndMirrorsWhenTheyAreExchanged) {
    std::mt19937 random(1);
    int equal = 0;
    for (int i = 0; i < 20000; ++i) {
        const json a = random_tree(random, 3), b = random_tree(random, 3);
        const Changes forth = counts_difference(a, b), back = counts_difference(b, a);
        ASSERT_EQ(forth.empty(), a == b) << a << " " << b;
        ASSERT_EQ(forth.size(), back.size()) << a << " " << b;
        for (const CountChange& change : forth)
            ASSERT_EQ(std::count(back.begin(), back.end(),
                                 CountChange{change.place, change.after, change.before,
                                             change.after_text, change.before_text}),
                      1)
                << a << " " << b << " " << change.place;
        equal += a == b;
    }
    EXPECT_GT(equal, 100);
}

}  // namespace
}  // namespace scb::golden
