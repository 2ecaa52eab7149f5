#include <algorithm>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/golden/results.h"
#include "app/study/mutation.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "golden/run/check_cases.h"
#include "golden/run/work_folder.h"
#include "golden/suite/baseline.h"
#include "scb/error.h"

namespace scb::app {
namespace {

/// The comparisons that a mutation must fail: the kind of case that reveals it; null if the
/// comparison need not fail.
struct Expected {
    const char* name;
    golden::RunMutation mutation;
    const char *counts, *ids, *colors;
};

constexpr const char *a_query = "`collide` of slab cut balls and many frames",
                     *level_7 = "`levels --levels 7`", *level_5 = "`levels --levels 5`",
                     *rejections = "`rejections` of slab cut balls";

golden::RunMutation of_hierarchy_or_query(Mutation mutation) {
    return {{"--mutation", std::string(mutation_names[mutation])}};
}

const Expected expectations[] = {
    {"drop-node", of_hierarchy_or_query(Mutation::drop_node), a_query, level_7, level_7},
    {"nudge-radius", of_hierarchy_or_query(Mutation::nudge_radius), nullptr, level_5, level_5},
    {"flip-comparison", of_hierarchy_or_query(Mutation::flip_comparison), a_query, rejections,
     rejections},
    {"swap-stages", of_hierarchy_or_query(Mutation::swap_stages), a_query, nullptr, rejections},
    {"shift-color", {{"--shift-color"}, true}, nullptr, nullptr, "`levels`"},
};

/// The comparisons that the cases make. Others cannot be expected to fail.
struct Compared {
    bool counts = false, ids = false, colors = false;
};

/// The cases that revealed a mutation.
struct Caught {
    std::vector<std::string> counts, ids, colors, could_not_run;
    std::size_t cases = 0;

    void add(const golden::CaseResult& result) {
        if (!golden::is_failure(result.verdict)) return;
        // A crashed case has compared nothing.
        if (result.verdict == golden::Verdict::could_not_run)
            return could_not_run.push_back(result.name);
        ++cases;
        if (!result.counts.empty()) counts.push_back(result.name);
        if (result.ids) ids.push_back(result.name);
        if (result.colors) colors.push_back(result.name);
    }
};

std::string some_of(const std::vector<std::string>& names) {
    constexpr std::size_t most = 4;
    if (names.empty()) return "none";
    std::string text = std::to_string(names.size()) + ": ";
    for (std::size_t i = 0; i < names.size() && i < most; ++i)
        text += (i == 0 ? "" : ", ") + names[i];
    return text + (names.size() > most ? ", ..." : "");
}

/// The verdict on a mutation.
struct Judgement {
    std::string text;
    bool caught = true;
};

Judgement judgement(const Expected& expected, const Compared& compared, const Caught& caught,
                    std::size_t cases) {
    Judgement judged;
    std::string lacking, lines, advice;
    const auto judge = [&](const char* what, bool is_compared, const char* shows_in,
                           const std::vector<std::string>& names) {
        lines += format("    %-8s", what) + (is_compared ? some_of(names) : "not compared") + "\n";
        if (!is_compared || shows_in == nullptr || !names.empty()) return;
        lacking += (lacking.empty() ? "" : ", ") + std::string(what);
        advice += "    To catch it by " + std::string(what) + ", add a case of " + shows_in +
                  " that compares " + what + ".\n";
    };
    judge("counts", compared.counts, expected.counts, caught.counts);
    judge("ids", compared.ids, expected.ids, caught.ids);
    judge("colors", compared.colors, expected.colors, caught.colors);
    if (!caught.could_not_run.empty())
        lines += "    could not run " + some_of(caught.could_not_run) + "\n";
    judged.caught = lacking.empty();
    judged.text = format("%-16s caught by %zu of %zu cases", expected.name, caught.cases, cases);
    if (!judged.caught) judged.text += ": NOT CAUGHT by " + lacking;
    judged.text += "\n" + lines + advice;
    return judged;
}

/// The comparisons of the cases, without skipped cases. Throws InputError if a case differs
/// already: then mutations would prove nothing.
Compared compared_by(const std::vector<golden::GoldenCase>& cases,
                     const std::vector<golden::CaseResult>& results) {
    Compared compared;
    for (const golden::CaseResult& result : results) {
        if (golden::is_failure(result.verdict))
            throw InputError(result.name + " differs without any error: " + result.message +
                             " Mend or update that first.");
        if (result.verdict == golden::Verdict::skipped) continue;
        const auto golden =
            std::find_if(cases.begin(), cases.end(),
                         [&](const golden::GoldenCase& c) { return c.name == result.name; });
        compared.counts |= golden->counts;
        compared.ids |= golden->ids;
        compared.colors |= golden->colors;
    }
    if (!compared.counts && !compared.ids && !compared.colors)
        throw InputError("All cases were skipped, so nothing can be proven: " + results[0].message);
    return compared;
}

int run(const GoldenOptions& options, const Console& console) {
    options.check();
    const golden::Suite suite = golden::load_suite(options.suite);
    golden::check_readable(options.baselines_folder());
    golden::GoldenCheck check;
    check.cases = options.chosen(suite);
    check.settings = options.settings();
    check.jobs = options.job_count();
    const InterruptWatch watch;
    check.settings.stopped = [&watch] { return watch.signal() != 0; };
    Progress progress(console, check.cases.size() * (1 + std::size(expectations)));
    const auto results = [&](const golden::RunMutation& mutation) {
        const golden::GoldenWork work;
        golden::GoldenCheck mutated = check;
        mutated.settings.work = &work;
        mutated.settings.workers = std::make_shared<golden::CommandWorkers>();  // end before `work`
        mutated.settings.mutation = mutation;
        mutated.folders = {options.baselines_folder(), work.candidates(), ""};
        return golden::check_cases(mutated,
                                   [&] {
                                       progress.step("cases");
                                       return watch.signal() == 0;
                                   })
            .results;
    };
    const std::vector<golden::CaseResult> unharmed = results({});
    const Compared compared = watch.signal() == 0 ? compared_by(check.cases, unharmed) : Compared{};
    std::string text;
    bool all_caught = true;
    for (const Expected& expected : expectations) {
        if (watch.signal() != 0) break;
        Caught caught;
        for (const golden::CaseResult& result : results(expected.mutation)) caught.add(result);
        if (watch.signal() != 0) break;
        const Judgement judged = judgement(expected, compared, caught, check.cases.size());
        all_caught &= judged.caught;
        text += judged.text;
    }
    print_result(text);
    if (watch.signal() != 0) {
        console.note("scb: interrupted; not all errors were tried.");
        return exit_interrupted(watch.signal());
    }
    return all_caught ? exit_done : exit_different;
}

}  // namespace

void add_golden_selftest(const Command& golden, const Console& console, Action& action) {
    const Command command = golden.add_subcommand(
        "selftest", "Prove that the suite can fail: errors on purpose must turn cases red");
    const auto options = std::make_shared<GoldenOptions>();
    add_golden_options(command, *options);
    command.footer(
        "The errors: a node dropped, a radius nudged by a thousandth, a comparison of the overlap "
        "test flipped, two of\n"
        "its stages swapped, a color shifted by 1 of 255. Each error must show in the counts, ids "
        "and colors that it can\n"
        "change, if a case compares them. If an error does not show, the exit status is 1, and a "
        "message says which kind of\n"
        "case to add.");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
