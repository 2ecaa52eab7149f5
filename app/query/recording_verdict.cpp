#include "app/query/recording_verdict.h"

#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

using render::count_text;
using render::counted;
using scenes::FrameJudgement;
using scenes::ProblemGroup;
using scenes::RecordingJudgement;
using scenes::TreeJudgement;

/// The kinds of errors with their counts.
std::string wrong_words(const RecordingJudgement& judged) {
    std::string text;
    const auto add = [&text](std::uint64_t count, const char* one, const char* several) {
        if (count > 0) text += (text.empty() ? ": " : ", ") + counted(count, one, several);
    };
    std::uint64_t faults = 0, tests = 0, answers = 0;
    for (const TreeJudgement& tree : judged.trees) faults += tree.problems.size();
    for (const ProblemGroup& group : judged.test_problems) tests += group.count;
    add(faults, "fault of trees", "faults of trees");
    add(judged.poses.size(), "query that fits another pose", "queries that fit another pose");
    add(tests, "test that went wrong", "tests that went wrong");
    for (const ProblemGroup& group : judged.answers) answers += group.count;
    add(answers, "wrong answer", "wrong answers");
    add(judged.total(&FrameJudgement::missed), "pair missed", "pairs missed");
    add(judged.total(&FrameJudgement::false_pairs), "false pair", "false pairs");
    add(judged.odd.count, "record that contradicts its tree",
        "records that contradict their trees");
    return "Wrong" + text;
}

std::string verdict_words(const RecordingJudgement& judged) {
    switch (judged.verdict()) {
        case scenes::Verdict::valid:
            return "Valid";
        case scenes::Verdict::partly_judged:
            return "Nothing wrong in what could be judged";
        case scenes::Verdict::wrong:
            break;
    }
    return wrong_words(judged);
}

std::string not_judged_words(const scenes::NotJudged& part) {
    return count_text(part.count) + (part.of > 0 ? " of " + count_text(part.of) : std::string()) +
           " " + part.what + ": " + part.why;
}

}  // namespace

std::string cost_finding_words(const scenes::CostFinding& cost) {
    using Kind = scenes::CostFinding::Kind;
    switch (cost.kind) {
        case Kind::repeated:
            return count_text(cost.count) + " of " + count_text(cost.of) +
                   " tests of volumes repeat an earlier one of their query; the first: " +
                   cost.where;
        case Kind::deep:
            return cost.where + " is " + count_text(cost.count) + " deep, where " +
                   count_text(cost.of) + " would do";
        case Kind::loose:
            return count_text(cost.count) + " of " + count_text(cost.of) + " boxes of " +
                   cost.where + " are much larger than what is below them; with boxes that fit, " +
                   count_text(cost.tests_if_tight) + " of " + count_text(cost.tests) +
                   " tests of volumes would be made";
    }
    return {};
}

std::vector<std::string> verdict_lines(const RecordingJudgement& judged) {
    std::vector<std::string> lines;
    lines.push_back(verdict_words(judged) + ".");
    if (!judged.damage.empty()) lines.push_back("Not whole: " + judged.damage);
    for (const scenes::NotJudged& part : judged.not_judged)
        lines.push_back("Not judged: " + not_judged_words(part) + ".");
    return lines;
}

}  // namespace scb::app
