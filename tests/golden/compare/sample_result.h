#pragma once

#include <limits>

#include "golden/compare/result.h"

namespace scb::golden {

/// A result in which every field has a value of its own, and cases with every verdict.
inline SuiteResult sample_result() {
    CaseResult full;
    full.name = "levels-spheres-scb";
    full.verdict = Verdict::different;
    full.cause = "Body B moved: 0.02 along x.";
    full.message = "1 count and 19 pixels differ.";
    full.lines = {"node 412, level 7, is missing: 19 pixels", "n_v of frame 100: 812, was 811"};
    full.counts = {{"frames/100/n_v", 811, 812},
                   {"gone", std::numeric_limits<std::int64_t>::min(), {}},
                   {"come", {}, std::numeric_limits<std::int64_t>::max()},
                   {"text", {}, {}, "\"a\"", "0.5"}};
    full.ids = IdDifference{
        19, {4, 5, 9, 11}, {{412, 19, 0, 19, {4, 5, 9, 11}}, {0xFFFFFFFF, 7, 9, 2, {6, 6, 8, 7}}}};
    full.owners = {"node 411 of A, level 7", ""};
    full.colors.emplace();
    full.colors->pixels = 21;
    full.colors->box = {3, 4, 10, 12};
    full.colors->largest = 3;
    full.colors->beyond = {21, 17, 1};
    full.focus = {3, 4, 9, 11};
    full.tolerance = {2, 15};
    full.variant = 2;
    full.picture = {"a/baseline.png", "a/candidate.png", "a/difference.png"};
    full.id_picture = {"b/baseline.png", "b/candidate.png", "b/difference.png"};
    full.reproduce = "scb golden check levels-spheres-scb";
    full.update = "scb golden update levels-spheres-scb";
    full.traces = {"before.trace", "after.trace"};
    full.trace_difference = "1 frame in both\n";
    full.diff = "scb diff before.trace after.trace";
    full.view = "full.view.html#frame=1&nodes=2,3";
    full.seconds = 0.1;

    SuiteResult result;
    result.suite = "golden/cases.json";
    result.environment = {{"scb", "0.1.0"}, {"mesa", "22.3.6"}, {"eigen", "3.4.0"}};
    result.shard = "2/3";
    result.incomplete = "Interrupted.";
    result.cases.push_back(full);
    for (const Verdict verdict : {Verdict::same, Verdict::size_differs, Verdict::missing_baseline,
                                  Verdict::new_output, Verdict::could_not_run, Verdict::skipped}) {
        CaseResult plain;
        plain.name = "case-" + std::to_string(static_cast<int>(verdict));
        plain.verdict = verdict;
        plain.message = "The verdict is " + std::string(verdict_names[verdict]) + ".";
        plain.seconds = 1.0 / 3;
        result.cases.push_back(plain);
    }
    return result;
}

}  // namespace scb::golden
