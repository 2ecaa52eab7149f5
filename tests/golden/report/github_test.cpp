#include "golden/report/github.h"

#include <gtest/gtest.h>

#include <string>

#include "core/base/text_format.h"
#include "tests/golden/compare/sample_result.h"

namespace scb::golden {
namespace {

CaseResult failing_case(const std::string& name, std::size_t lines) {
    CaseResult result;
    result.name = name;
    result.verdict = Verdict::different;
    result.message = "It differs.";
    for (std::size_t i = 1; i <= lines; ++i) result.lines.push_back("line " + std::to_string(i));
    return result;
}

SuiteResult failing_suite(std::size_t cases, std::size_t lines) {
    SuiteResult result;
    for (std::size_t i = 1; i <= cases; ++i)
        result.cases.push_back(failing_case("case-" + std::to_string(i), lines));
    return result;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(GithubAnnotations, HaveOneLineForEachFailingCase) {
    EXPECT_EQ(github_annotations(sample_result()),
              "::error title=incomplete::Interrupted.\n"
              "::error title=levels-spheres-scb (different)::Body B moved: 0.02 along x. 1 count "
              "and 19 pixels differ."
              "%0Aframes/100/n_v: 811 -> 812 (+1)"
              "%0Agone: -9,223,372,036,854,775,808 -> none"
              "%0Acome: none -> 9,223,372,036,854,775,807"
              "%0Atext: \"a\" -> 0.5"
              "%0Anode 412, level 7, is missing: 19 pixels%0An_v of frame 100: 812, was 811\n"
              "::error title=case-2 (size differs)::The verdict is size differs.\n"
              "::error title=case-3 (missing baseline)::The verdict is missing baseline.\n"
              "::error title=case-4 (new output)::The verdict is new output.\n"
              "::error title=case-5 (could not run)::The verdict is could not run.\n");
    EXPECT_EQ(github_annotations({}), "");
}

TEST(GithubAnnotations, SayWhichCountsDiffer) {
    SuiteResult result = failing_suite(1, 0);
    for (int i = 0; i < 12; ++i)
        result.cases[0].counts.push_back({"frames/0/stages/s" + std::to_string(i), 20627, 20630});
    const std::string text = github_annotations(result);
    EXPECT_NE(text.find("%0Aframes/0/stages/s0: 20,627 -> 20,630 (+3)%0A"), std::string::npos)
        << text;
    EXPECT_TRUE(text.ends_with("s9: 20,627 -> 20,630 (+3)%0Aand 2 more counts\n")) << text;
}

TEST(GithubAnnotations, EscapeWhatGithubWouldRead) {
    SuiteResult result;
    result.cases = {failing_case("a:b,c%d\r\n::error::e", 0)};
    result.cases[0].message = "50% of a:b,c\r\n::warning::no%0A";
    EXPECT_EQ(github_annotations(result),
              "::error title=a%3Ab%2Cc%25d\\r\\n%3A%3Aerror%3A%3Ae (different)::"
              "50%25 of a:b,c\\r\\n::warning::no%250A\n");
}

TEST(GithubAnnotations, AreAsManyAsGithubShows) {
    EXPECT_EQ(occurrences(github_annotations(failing_suite(10, 1)), "::error title=case"), 10u);
    const std::string many = github_annotations(failing_suite(12, 1));
    EXPECT_EQ(occurrences(many, "::error "), 10u);
    EXPECT_NE(many.find("case-9 "), std::string::npos);
    EXPECT_TRUE(many.ends_with("::error title=3 more cases::case-10, case-11, case-12\n")) << many;
}

TEST(GithubAnnotations, AreShortWhateverTheCases) {
    EXPECT_TRUE(
        github_annotations(failing_suite(1, 17)).ends_with("line 16%0A... and 1 more line\n"));
    SuiteResult result = failing_suite(5000, 2000);
    EXPECT_LT(github_annotations(result).size(), 16000u);
    result.cases[0].message = std::string(1999, 'a') + "τ" + std::string(100000, 'a');
    EXPECT_NE(github_annotations(result).find("a...%0Aline 1"), std::string::npos);
}

TEST(GithubSummary, HasVerdictsAndFailingCases) {
    const std::string text = github_summary(sample_result());
    EXPECT_EQ(text.substr(0, text.find("### case-3")),
              "## Golden: 5 of 7 cases failed, shard 2/3\n"
              "\n"
              "**incomplete**: Interrupted.\n"
              "\n"
              "| verdict | cases |\n"
              "| --- | ---: |\n"
              "| same | 1 |\n"
              "| different | 1 |\n"
              "| size differs | 1 |\n"
              "| missing baseline | 1 |\n"
              "| new output | 1 |\n"
              "| could not run | 1 |\n"
              "| skipped | 1 |\n"
              "\n"
              "### levels-spheres-scb\n"
              "\n"
              "**different**: Body B moved: 0.02 along x. 1 count and 19 pixels differ.\n"
              "\n"
              "```\n"
              "frames/100/n_v: 811 -> 812 (+1)\n"
              "gone: -9,223,372,036,854,775,808 -> none\n"
              "come: none -> 9,223,372,036,854,775,807\n"
              "text: \"a\" -> 0.5\n"
              "node 412, level 7, is missing: 19 pixels\n"
              "n_v of frame 100: 812, was 811\n"
              "```\n"
              "\n"
              "```sh\n"
              "scb golden check levels-spheres-scb\n"
              "scb diff before.trace after.trace\n"
              "scb golden update levels-spheres-scb\n"
              "```\n"
              "\n"
              "### case-2\n"
              "\n"
              "**size differs**: The verdict is size differs.\n"
              "\n");
    SuiteResult good;
    good.cases.resize(3);
    EXPECT_EQ(
        github_summary(good),
        "## Golden: nothing differs\n\n| verdict | cases |\n| --- | ---: |\n| same | 3 |\n\n");
}

TEST(GithubSummary, ShowsTextAsItIs) {
    SuiteResult result = failing_suite(1, 0);
    result.cases[0].name = "a|b <script> `c` *d* _e_ [f](g) #h\n### i";
    result.cases[0].lines = {"````sh", "<b> & |"};
    const std::string text = github_summary(result);
    EXPECT_NE(
        text.find(
            "### a\\|b \\<script\\> \\`c\\` \\*d\\* \\_e\\_ \\[f\\](g) \\#h\\\\n\\#\\#\\# i\n"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("\n`````\n````sh\n<b> & |\n`````\n"), std::string::npos) << text;
}

TEST(GithubSummary, StaysWithinTheLimitAndSaysWhatIsLeftOut) {
    for (const std::size_t largest :
         {std::size_t{4096}, std::size_t{30000}, largest_github_summary})
        for (const std::size_t cases : {1u, 3u, 50u, 2000u})
            for (const std::size_t lines : {0u, 5u, 300u}) {
                const std::string text = github_summary(failing_suite(cases, lines), largest);
                ASSERT_LE(text.size(), largest);
                const std::size_t shown = occurrences(text, "### case-");
                const std::string rest = counted(cases - shown, "case", "cases") +
                                         " more failed; the report has all of them.\n";
                EXPECT_EQ(text.ends_with(rest), shown < cases) << text.substr(text.size() - 100);
                EXPECT_GT(shown, 0u);
                EXPECT_EQ(occurrences(text, "```") % 2, 0u);
            }
}

TEST(GithubSummary, ShowsTheFirstLinesOfEachCase) {
    SuiteResult result = failing_suite(4, 3);
    result.cases[0] = failing_case("long", 31);
    const std::string text = github_summary(result, 20000);
    EXPECT_EQ(occurrences(text, "line 3\n"), 4u);
    EXPECT_NE(text.find("line 30\n... and 1 more line\n```\n"), std::string::npos);
    EXPECT_EQ(text.find("line 31"), std::string::npos);
}

TEST(GithubSummary, ShowsCasesWithLongNamesAndSentences) {
    SuiteResult result = failing_suite(3, 1);
    for (CaseResult& one : result.cases) {
        one.name = std::string(5000, '*');
        one.message = std::string(5000, '_');
    }
    EXPECT_EQ(occurrences(github_summary(result, 4096), "### "), 3u);
}

}  // namespace
}  // namespace scb::golden
