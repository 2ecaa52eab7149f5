#include "golden/report/merge.h"

#include <gtest/gtest.h>

#include "scb/error.h"

namespace scb::golden {
namespace {

CaseResult named(const std::string& name) {
    CaseResult result;
    result.name = name;
    return result;
}

ResultPart part(const std::string& shard, const std::vector<std::string>& names) {
    ResultPart made;
    made.file = "shard-" + shard.substr(0, shard.find('/')) + "/results.json";
    made.result.suite = "cases.json";
    made.result.shard = shard;
    made.result.environment = {{"scb", "0.1.0"}, {"mesa", "22.3.6"}};
    for (const std::string& name : names) made.result.cases.push_back(named(name));
    return made;
}

std::string names_of(const SuiteResult& result) {
    std::string names;
    for (const CaseResult& c : result.cases) names += (names.empty() ? "" : " ") + c.name;
    return names;
}

std::string refusal(const std::vector<ResultPart>& parts) {
    try {
        merge_results(parts);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Merge, PutsTheCasesOfShardsIntoTheOrderOfTheSuite) {
    const SuiteResult merged =
        merge_results({part("2/3", {"b", "e"}), part("3/3", {"c"}), part("1/3", {"a", "d"})});
    EXPECT_EQ(names_of(merged), "a b c d e");
    EXPECT_EQ(merged.incomplete, "");
    EXPECT_EQ(merged.shard, "");
    EXPECT_FALSE(has_failed(merged));
    // More shards than cases.
    EXPECT_EQ(merge_results({part("1/3", {"a"}), part("2/3", {"b"}), part("3/3", {})}).incomplete,
              "");
}

TEST(Merge, FailsWhereShardsAreMissing) {
    const SuiteResult one = merge_results({part("2/2", {"b"})});
    EXPECT_EQ(one.incomplete,
              "These shards are missing: 1/2; see why, and give their results.json too.");
    EXPECT_TRUE(has_failed(one));
    EXPECT_EQ(merge_results({part("2/4", {"b"}), part("4/4", {})}).incomplete,
              "These shards are missing: 1/4, 3/4; see why, and give their results.json too.");
    EXPECT_EQ(merge_results({part("2/4", {"b"}), part("4/4", {})}).shard, "2/4, 4/4");
}

TEST(Merge, FailsWhereAShardHasTooFewCases) {
    for (const std::vector<std::string>& second :
         {std::vector<std::string>{}, std::vector<std::string>{"b", "d", "f", "h"}})
        EXPECT_NE(merge_results({part("1/2", {"a", "c", "e"}), part("2/2", second)})
                      .incomplete.find("not dealt from the same cases"),
                  std::string::npos);
    ResultPart interrupted = part("2/2", {"b"});
    interrupted.result.incomplete = "It was interrupted.";
    EXPECT_EQ(merge_results({part("1/2", {"a", "c"}), interrupted}).incomplete,
              "It was interrupted.");
}

TEST(Merge, FailsWhereNothingWasChecked) {
    EXPECT_EQ(merge_results({part("", {})}).incomplete, "No case was checked.");
    EXPECT_EQ(merge_results({part("1/1", {})}).incomplete, "No case was checked.");
}

TEST(Merge, TakesRunsOfPartsOneBehindTheOther) {
    EXPECT_EQ(names_of(merge_results({part("", {"b", "c"}), part("", {"a"})})), "b c a");
}

TEST(Merge, KeepsEveryVersion) {
    ResultPart other = part("2/3", {"b"});
    other.result.environment = {{"scb", "0.1.0"}, {"mesa", "24.0.1"}, {"llvm", "17"}};
    const SuiteResult merged = merge_results({part("1/3", {"a"}), other, part("3/3", {"c"})});
    EXPECT_EQ(merged.environment, (std::vector<std::pair<std::string, std::string>>{
                                      {"scb", "0.1.0"},
                                      {"mesa", "22.3.6 (shard 1/3, shard 3/3); 24.0.1 (shard 2/3)"},
                                      {"llvm", "17 (shard 2/3)"}}));
}

TEST(Merge, RefusesWhatIsNotOfOneRun) {
    EXPECT_EQ(refusal({part("1/2", {"a"}), part("1/2", {"a"})}),
              "shard-1/results.json: the shard 1/2 is in other results too; give the results of "
              "one run.");
    EXPECT_EQ(refusal({part("1/2", {"a"}), part("2/2", {"a"})}),
              "shard-2/results.json: the case a is in other results too; give the results of one "
              "run.");
    EXPECT_EQ(refusal({part("1/2", {"a"}), part("2/3", {"b"})}),
              "shard-2/results.json: these are results of shard 2/3, and others of shard 1/2; give "
              "the results of one run.");
    EXPECT_NE(refusal({part("1/2", {"a"}), part("", {"b"})}).find("no shard"), std::string::npos);
    EXPECT_NE(refusal({part("7", {"a"})}).find("shard-7/results.json: shard: "), std::string::npos);
    ResultPart other = part("2/2", {"b"});
    other.result.suite = "other.json";
    EXPECT_NE(refusal({part("1/2", {"a"}), other}).find("report them apart"), std::string::npos);
}

}  // namespace
}  // namespace scb::golden
