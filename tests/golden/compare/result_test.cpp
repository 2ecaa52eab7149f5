#include "golden/compare/result.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scb/error.h"
#include "tests/golden/compare/sample_result.h"

namespace scb::golden {
namespace {

using nlohmann::json;

json sample_json() { return json::parse(result_json(sample_result()).dump()); }

std::string refusal(const json& document) {
    try {
        result_of(document, "out/results.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Result, SurvivesTheRoundTrip) {
    EXPECT_EQ(result_of(sample_json(), "results.json"), sample_result());
    EXPECT_EQ(result_of(json::parse(result_json({}).dump()), "results.json"), SuiteResult{});
}

TEST(Result, SurvivesTheRoundTripWithoutText) {
    EXPECT_EQ(result_of(json(result_json(sample_result())), "results.json"), sample_result());
}

TEST(Result, KeepsEveryThreshold) {
    SuiteResult result = sample_result();
    EXPECT_EQ(result_json(result)["cases"][0]["colors"]["beyond"],
              (nlohmann::ordered_json{21, 17, 1}));
    for (std::size_t d = 0; d < 256; ++d) result.cases[0].colors->beyond[d] = 1000 - d;
    EXPECT_EQ(result_of(json::parse(result_json(result).dump()), "results.json"), result);
    result.cases[0].colors->beyond = {};
    result.cases[0].colors->beyond[200] = 1;
    EXPECT_EQ(result_of(json::parse(result_json(result).dump()), "results.json"), result);
}

/// Calls `visit` with a pointer to every object in the document.
template <typename Visit>
void visit_objects(const json& value, const json::json_pointer& at, Visit visit) {
    if (value.is_object()) visit(at);
    if (!value.is_structured()) return;
    for (const auto& [key, child] : value.items()) {
        const json::json_pointer below =
            value.is_array() ? at / static_cast<std::size_t>(std::stoul(key)) : at / key;
        visit_objects(child, below, visit);
    }
}

TEST(Result, IsRefusedWhereAnyFieldIsMissingUnknownOrOfAnotherType) {
    const json sample = sample_json();
    int fields = 0;
    visit_objects(sample, json::json_pointer(), [&](const json::json_pointer& at) {
        json unknown = sample;
        unknown[at]["surprise"] = 1;
        const std::string sentence = refusal(unknown);
        EXPECT_TRUE(sentence.starts_with("out/results.json: ")) << sentence;
        EXPECT_NE(sentence.find("unknown field \"surprise\""), std::string::npos) << sentence;
        for (const auto& [key, value] : sample[at].items()) {
            ++fields;
            json missing = sample;
            missing[at].erase(key);
            const std::string lack = refusal(missing);
            EXPECT_TRUE(lack.starts_with("out/results.json: ")) << lack;
            EXPECT_NE(lack.find("the field \"" + key + "\" is missing"), std::string::npos) << lack;
            json wrong = sample;
            wrong[at][key] = true;
            const std::string other = refusal(wrong);
            EXPECT_NE(other.find(key + ": expected "), std::string::npos) << other;
            EXPECT_NE(other.find("found true."), std::string::npos) << other;
        }
    });
    EXPECT_GT(fields, 150);
}

TEST(Result, IsRefusedByPlaceAndValue) {
    const auto with = [](const char* pointer, const json& value) {
        json document = sample_json();
        document[json::json_pointer(pointer)] = value;
        return refusal(document);
    };
    EXPECT_EQ(with("/cases/3/verdict", "fine"),
              "out/results.json: cases[3].verdict: expected a verdict, found \"fine\".");
    EXPECT_EQ(with("/cases/0/ids/changes/1/id", 4294967296),
              "out/results.json: cases[0].ids.changes[1].id: expected a whole number from 0 to "
              "4294967295, found 4294967296.");
    EXPECT_EQ(with("/cases/0/variant", -1),
              "out/results.json: cases[0].variant: expected a whole number from 0 to 2147483647, "
              "found -1.");
    EXPECT_EQ(with("/cases/0/colors/largest", 256),
              "out/results.json: cases[0].colors.largest: expected a whole number from 0 to 255, "
              "found 256.");
    EXPECT_EQ(with("/cases/0/colors/box", {1, 2, 3}),
              "out/results.json: cases[0].colors.box: expected [left, top, right, bottom], found "
              "[1,2,3].");
    EXPECT_EQ(with("/cases/0/colors/beyond", json(std::vector<int>(257, 1))),
              "out/results.json: cases[0].colors.beyond: expected at most 256 numbers, found 257.");
    EXPECT_EQ(with("/cases/0/ids/pixels", 1.5),
              "out/results.json: cases[0].ids.pixels: expected a whole number from 0 to "
              "9223372036854775807, found 1.5.");
    EXPECT_EQ(with("/cases/0/counts/0/before", 18446744073709551615u),
              "out/results.json: cases[0].counts[0].before: expected a whole number from "
              "-9223372036854775808 to 9223372036854775807, found 18446744073709551615.");
    EXPECT_EQ(with("/cases/0/seconds", -0.5),
              "out/results.json: cases[0].seconds: expected a number from 0 to "
              "1.7976931348623157e+308, found -0.5.");
    EXPECT_EQ(with("/cases", 7), "out/results.json: cases: expected a list, found 7.");
    EXPECT_EQ(refusal(json::array()), "out/results.json: expected an object, found [].");
}

constexpr Verdict all[] = {
    Verdict::same,       Verdict::different,     Verdict::size_differs, Verdict::missing_baseline,
    Verdict::new_output, Verdict::could_not_run, Verdict::skipped};

TEST(Verdicts, AreFoundByTheirNames) {
    for (const Verdict verdict : all)
        EXPECT_EQ(verdict_names.find(verdict_names[verdict]), verdict);
    EXPECT_EQ(verdict_names[Verdict::missing_baseline], "missing baseline");
    EXPECT_EQ(verdict_names[Verdict::skipped], "skipped");
    EXPECT_EQ(verdict_names.find("Same"), std::nullopt);
    EXPECT_EQ(verdict_names.find(""), std::nullopt);
}

TEST(Verdicts, AllButSameAndSkippedFail) {
    for (const Verdict verdict : all)
        EXPECT_EQ(is_failure(verdict), verdict != Verdict::same && verdict != Verdict::skipped)
            << verdict_names[verdict];
}

}  // namespace

}  // namespace scb::golden
