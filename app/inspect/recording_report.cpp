#include "app/inspect/recording_report.h"

#include <algorithm>
#include <map>

#include "app/query/recording_verdict.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "render/overlay/figure_layout.h"
#include "scenes/recordings/judgement_words.h"

namespace scb::app {
namespace {

using render::count_text;
using render::counted;
using scenes::FrameJudgement;
using scenes::ProblemGroup;
using scenes::RecordingJudgement;
using scenes::TreeJudgement;

/// The first frame and the amount in it, and the worst frame.
std::string when(const WatchedProblem& problem) {
    std::string words = problem.gaps
                            ? "in " + count_text(problem.frames) + " frames, first at frame " +
                                  std::to_string(problem.since)
                            : "since frame " + std::to_string(problem.since);
    if (problem.worst_at != problem.since)
        words += ", by " + amount_words(problem.since_amount) + " there; by " +
                 amount_words(problem.problem.amount) + " at frame " +
                 std::to_string(problem.worst_at);
    if (problem.links_at >= 0)
        words += "; at frame " + std::to_string(problem.links_at) +
                 " the node got other children or items, and kept its volume of frame " +
                 std::to_string(problem.kept_from);
    else if (problem.stale)
        words += "; stale: the volume dates from frame " + std::to_string(problem.recorded_at);
    return words;
}

std::string tree_name(const TreeJudgement& tree) {
    const std::string number = "tree " + std::to_string(tree.number);
    return tree.name.empty() ? number : number + " \"" + tree.name + "\"";
}

/// The problems of one kind: their number, and the worst ones.
std::string faults_text(const std::vector<const WatchedProblem*>& problems, std::size_t top) {
    const TreeFault fault = problems[0]->problem.fault;
    std::string text;
    if (problems.size() > 1) {
        text = "    " + count_text(problems.size()) + " " + scenes::fault_words(fault);
        double most = 0;
        int first = problems[0]->since;
        std::uint64_t inherited = 0;
        for (const WatchedProblem* problem : problems) {
            most = std::max(most, problem->problem.amount);
            first = std::min(first, problem->since);
            inherited += problem->problem.inherited;
        }
        if (most > 0) text += ", by up to " + amount_words(most);
        text += ", the first since frame " + std::to_string(first);
        if (inherited > 0)
            text += "; " + count_text(inherited) +
                    " of these nodes stand above others that miss the same items";
        text += most > 0 ? "; the worst:\n" : "; the first:\n";
    }
    for (std::size_t i = 0; i < std::min(top, problems.size()); ++i)
        text += "    " + std::string(problems.size() > 1 ? "  " : "") + problems[i]->words + " (" +
                when(*problems[i]) + ")\n";
    return text;
}

std::string trees_text(const RecordingJudgement& judged, std::size_t top, std::size_t cases) {
    std::string text = "Trees\n";
    for (const TreeJudgement& tree : judged.trees) {
        const char* valid = tree.unfinished   ? "the file breaks off in it, not judged"
                            : tree.nodes == 0 ? "not judged"
                                              : "valid";
        text +=
            "  " + tree_name(tree) + ": " + counted(tree.nodes, "node", "nodes") + ", depth " +
            std::to_string(tree.depth) +
            (tree.roots > 1 ? ", " + count_text(tree.roots) + " roots" : "") +
            (tree.in_several_leaves > 0
                 ? ", " + counted(tree.in_several_leaves, "triangle", "triangles") +
                       " in several leaves"
                 : "") +
            ": " +
            (tree.problems.empty() ? valid : counted(tree.problems.size(), "problem", "problems")) +
            "\n";
        std::map<TreeFault, std::vector<const WatchedProblem*>> by_fault;
        for (const WatchedProblem& problem : tree.problems)
            by_fault[problem.problem.fault].push_back(&problem);
        for (const auto& [fault, problems] : by_fault)
            text += faults_text(problems, cases > 1 ? cases : std::min<std::size_t>(top, 3));
        if (tree.fit)
            text += "    One change explains it: " + tree.fit->what + ". With it, " +
                    count_text(tree.fit->nodes) + " of " + count_text(tree.fit->of) +
                    " nodes contain what is below them (frame " + std::to_string(tree.fit_at) +
                    ").\n";
    }
    return text + "\n";
}

/// Words about tests of overlap, about bounds of distances, or about both, by the recorded queries.
std::string by_aim(const RecordingJudgement& judged, const std::string& overlap,
                   const std::string& distance) {
    if (judged.summary.measures == 0) return overlap;
    return judged.summary.measures == judged.summary.queries ? distance
                                                             : overlap + ", or " + distance;
}

std::string tests_text(const RecordingJudgement& judged) {
    if (judged.stages.empty() || judged.total(&FrameJudgement::volume_tests) == 0)
        return "Tests: no tests of volumes were recorded.\n\n";
    const auto name_of = [&judged](const scenes::StageJudgement& stage) {
        return stage.name == "overlap" ? by_aim(judged, stage.name, "bounds") : stage.name;
    };
    std::size_t width = 5;
    for (const auto& stage : judged.stages)
        width = std::max(width, character_count(name_of(stage)));
    std::string text =
        "Tests" + std::string(width - 3, ' ') + "      tests    false    wrong   " +
        by_aim(judged, "deep in each other, at least", "volumes nearer than the answer by") + "\n";
    for (const auto& stage : judged.stages) {
        text +=
            "  " + left_aligned(name_of(stage), width) +
            right_aligned(count_text(stage.tests), 11) +
            right_aligned(stage.false_positives > 0 ? count_text(stage.false_positives) : "", 9) +
            right_aligned(stage.wrong > 0 ? count_text(stage.wrong) : "", 9);
        if (stage.wrong > 0) text += format("   %.4g to %.4g", stage.least_depth, stage.most_depth);
        text += "\n";
    }
    const auto farthest =
        std::max_element(judged.stages.begin(), judged.stages.end(),
                         [](const auto& x, const auto& y) { return x.most_apart < y.most_apart; });
    if (farthest->most_apart > 0)
        text += "  farthest apart of the false ones: " + farthest->farthest + "\n";
    return text + "\n";
}

/// Queries whose tests fit another pose: the first ones of each pose.
std::string poses_text(const RecordingJudgement& judged, std::size_t top) {
    std::map<std::string, std::size_t> counts;
    std::string text;
    for (const auto& pose : judged.poses) {
        if (++counts[pose.pose] > std::min<std::size_t>(top, 3)) continue;
        text += std::string("Pose: the tests ") + (pose.only_volumes ? "of volumes " : "") + "at " +
                scenes::query_words(pose.query) + " fit " + pose.pose + ": " +
                count_text(pose.told.all_wrong()) +
                " are wrong with the recorded pose, none with this pose" +
                (pose.only_volumes ? ". Triangle tests fit the recorded pose.\n" : ".\n");
    }
    for (const auto& [pose, count] : counts)
        if (const std::size_t more = count - std::min(count, std::min<std::size_t>(top, 3)))
            text += "Pose: " + counted(more, "more query fits", "more queries fit") + " " + pose +
                    ".\n";
    return text.empty() ? text : text + "\n";
}

std::string groups_text(const char* title, const std::vector<ProblemGroup>& groups,
                        std::size_t cases) {
    std::string text;
    for (const ProblemGroup& group : groups) {
        if (text.empty()) text = std::string(title) + "\n";
        text += "  " + count_text(group.count) + ": " + group.what + "\n";
        for (std::size_t i = 0; i < std::min(cases, group.cases.size()); ++i)
            text += (i == 0 ? "      first: " : "             ") +
                    scenes::query_words(group.cases[i].query) + ": " + group.cases[i].words + "\n";
    }
    return text.empty() ? text : text + "\n";
}

/// The engine's log of the frames with errors.
std::string log_text(const RecordingJudgement& judged, std::size_t top) {
    std::string text;
    std::size_t frames = 0;
    for (const FrameJudgement& frame : judged.frames) {
        if (frame.log.empty() || frames++ >= top) continue;
        const std::string place = "  frame " + std::to_string(frame.frame) + ": ";
        for (const std::string& line : frame.log) text += place + line + "\n";
        if (frame.log_lines > frame.log.size())
            text += place + "and " +
                    counted(frame.log_lines - frame.log.size(), "more line", "more lines") + "\n";
    }
    return text.empty() ? text : "Log of frames with errors\n" + text + "\n";
}

/// The share of volume tests that this project's hierarchies need, for findings on the engine's
/// cost.
std::string own_words(const std::optional<InspectSettings>& settings) {
    if (!settings) return {};
    const Work& own = settings->tuning.rows[settings->tuning.recommended()].counts;
    return format("; this project's hierarchies take %.2g of the tests",
                  ratio(static_cast<double>(own.volume_tests),
                        static_cast<double>(settings->recorded->volume_tests)));
}

/// Findings on cost, and scaled bodies.
std::string costs_text(const RecordingJudgement& judged,
                       const std::optional<InspectSettings>& settings) {
    std::string text;
    for (const scenes::CostFinding& cost : judged.costs)
        text += "Cost: " + cost_finding_words(cost) +
                (cost.kind == scenes::CostFinding::Kind::repeated ? "" : own_words(settings)) +
                ".\n";
    for (const std::string& stretch : judged.stretches) text += "Scale: " + stretch + ".\n";
    return text + "\n";
}

std::string results_text(const RecordingJudgement& judged) {
    if (!judged.summary.has_results()) return "Results: none were recorded.\n\n";
    std::string text;
    if (judged.summary.answers > 0 || !judged.answers.empty()) {
        std::uint64_t wrong = 0;
        for (const ProblemGroup& group : judged.answers) wrong += group.count;
        text = "Results: " + counted(judged.distances, "distance", "distances") + " recorded, " +
               count_text(wrong) + " wrong.\n";
        if (judged.summary.pairs == 0) return text + "\n";
    }
    const bool has_pairs = judged.summary.has_pairs || judged.summary.pairs > 0;
    text += "Results: " + counted(judged.total(&FrameJudgement::pairs), "pair", "pairs") +
            (has_pairs ? " reported" : " met by the tests of triangles");
    if (judged.unknown_items < judged.total(&FrameJudgement::queries))
        text += ", " + count_text(judged.exact_pairs) +
                by_aim(judged, " intersect", " are near enough") + "; " +
                count_text(judged.total(&FrameJudgement::missed)) + " missed, " +
                count_text(judged.total(&FrameJudgement::false_pairs)) + " false" +
                (judged.grazing > 0 ? ", " + count_text(judged.grazing) + " within the tolerance"
                                    : std::string());
    text += ".\n";
    if (judged.ended_early > 0)
        text += count_text(judged.ended_early) + (judged.ended_early == 1 ? " query" : " queries") +
                " ended early, or broke off: pairs that they did not come to are not counted as "
                "missed.\n";
    return text + "\n";
}

std::string waste_text(const RecordingJudgement& judged) {
    const std::uint64_t tests =
        judged.total(&FrameJudgement::volume_tests) + judged.total(&FrameJudgement::item_tests);
    if (tests == 0) return {};
    const auto count = [&judged](PassReason reason) {
        return count_text(judged.wasted.by(reason));
    };
    if (!judged.summary.has_results())
        return "Wasted: " + count(PassReason::weak_test) + " of " + count_text(tests) +
               " tests are below volumes that do not even meet; what else led to nothing, only "
               "results tell.\n";
    return "Wasted: " + share(judged.wasted.all(), tests) + " of " + count_text(tests) +
           " tests: " + count(PassReason::loose_fit) + " below volumes that " +
           by_aim(judged, "meet though nothing below them does",
                  "are near enough though no triangles below them are") +
           ", " + count(PassReason::weak_test) + " below volumes that " +
           by_aim(judged, "do not even meet", "are farther apart") +
           (judged.wasted.by(PassReason::early) > 0
                ? ", " + count(PassReason::early) +
                      " below volumes that were tested before a near answer was known"
                : "") +
           (judged.wasted.by(PassReason::unjudged) > 0
                ? ", " + count(PassReason::unjudged) + " below volumes that are not judged"
                : "") +
           ".\n";
}

/// Lengths within which results are not judged.
std::string tolerance_text(const RecordingJudgement& judged) {
    const scenes::FrameJudgement* least = nullptr;
    const scenes::FrameJudgement* most = nullptr;
    const auto of = [](const FrameJudgement& f) {
        return std::max(f.tolerance.volumes, f.tolerance.triangles);
    };
    for (const FrameJudgement& f : judged.frames) {
        if (f.queries == 0) continue;
        if (!least || of(f) < of(*least)) least = &f;
        if (!most || of(f) > of(*most)) most = &f;
    }
    if (!most) return {};
    const auto words = [&](const FrameJudgement& f) {
        return format("%.3g", of(f)) +
               (judged.frames.size() > 1 ? " at frame " + std::to_string(f.frame) : "");
    };
    std::string text = "Tolerance: " + words(*most);
    if (of(*most) > 2 * of(*least)) text = "Tolerance: " + words(*least) + ", " + words(*most);
    text += most->tolerance.single ? ", of 32-bit numbers" : ", of 64-bit numbers";
    if (most->tolerance.away > 0)
        text += format(", up to %.3g from the origin", most->tolerance.away);
    return text +
           ". Volumes and triangles that are closer than that to touching are not judged.\n\n";
}

std::string frames_text(const RecordingJudgement& judged, std::size_t top) {
    if (judged.frames.size() < 2) return {};
    std::vector<FrameJudgement> frames = judged.frames;
    std::stable_sort(frames.begin(), frames.end(),
                     [](const FrameJudgement& a, const FrameJudgement& b) {
                         const auto errors = [](const FrameJudgement& f) {
                             return f.wrong + f.missed + f.false_pairs;
                         };
                         return std::pair(errors(a), a.wasted) > std::pair(errors(b), b.wasted);
                     });
    std::string text =
        "   frame  queries      tests     wasted    wrong   missed    false    pairs\n";
    for (std::size_t i = 0; i < std::min(top, frames.size()); ++i) {
        const FrameJudgement& f = frames[i];
        const auto cell = [](std::uint64_t count, std::size_t width) {
            return right_aligned(count_text(count), width);
        };
        text += right_aligned(std::to_string(f.frame), 8) + cell(f.queries, 9) +
                cell(f.volume_tests + f.item_tests, 11) + cell(f.wasted, 11) + cell(f.wrong, 9) +
                cell(f.missed, 9) + cell(f.false_pairs, 9) + cell(f.pairs, 9) + "\n";
    }
    if (frames.size() > top)
        text += "   ... " + counted(frames.size() - top, "more frame", "more frames") +
                ", which --json lists\n";
    return "\nThe frames with the most errors, then with the most waste\n" + text;
}

std::string odd_text(const scenes::OddRecords& records) {
    std::string text;
    for (const std::string& words : records.first) text += "Odd: " + words + ".\n";
    if (records.count > records.first.size())
        text += "Odd: " + count_text(records.count - records.first.size()) + " more of the kind.\n";
    return text;
}

}  // namespace

std::string recording_text(const InspectedRecording& recording,
                           const std::optional<InspectSettings>& settings) {
    const RecordingJudgement& judged = recording.judged;
    const std::size_t top = recording.top, cases = recording.cases;
    const std::vector<std::string> verdict = verdict_lines(judged);
    std::string text = verdict.front() + "\n" + recording.path +
                       (judged.engine.empty() ? "" : ", of " + judged.engine) + ": " +
                       counted(judged.frames.size(), "frame", "frames") + ", " +
                       counted(judged.total(&FrameJudgement::queries), "query", "queries") + ", " +
                       counted(judged.total(&FrameJudgement::volume_tests), "test", "tests") +
                       " of volumes, " + count_text(judged.total(&FrameJudgement::item_tests)) +
                       " of triangles\n";
    for (std::size_t i = 1; i < verdict.size(); ++i) text += verdict[i] + "\n";
    text += costs_text(judged, settings);
    text += poses_text(judged, top);
    text += trees_text(judged, top, cases) + tests_text(judged) +
            groups_text("Tests that went wrong", judged.test_problems, cases) +
            tolerance_text(judged) + results_text(judged) +
            groups_text("Wrong answers", judged.answers, cases) +
            groups_text("Missed pairs, by cause", judged.missed, cases) +
            groups_text("False pairs, by cause", judged.false_pairs, cases) +
            log_text(judged, top) + waste_text(judged) + frames_text(judged, top);
    text += odd_text(judged.odd) + odd_text(judged.unusable);
    for (const std::string& note : judged.notes) text += "Note: " + note + ".\n";
    return text;
}

}  // namespace scb::app
