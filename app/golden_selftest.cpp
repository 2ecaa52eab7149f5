#include <algorithm>
#include <memory>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/golden_check.h"
#include "app/golden_results.h"
#include "app/interrupt.h"
#include "app/mutation.h"
#include "app/progress.h"
#include "app/text_format.h"
#include "core/error.h"

namespace scb {
namespace {

/// In which comparisons a mutation must show: each in some case, and no other in any.
struct Expected {
    Mutation mutation;
    bool counts, ids, colors;
};

constexpr Expected expectations[] = {
    {Mutation::drop_node, true, true, true},       {Mutation::nudge_radius, false, true, true},
    {Mutation::flip_comparison, true, true, true}, {Mutation::swap_stages, true, false, true},
    {Mutation::shift_color, false, false, true},
};

/// The cases in which a mutation showed.
struct Caught {
    std::vector<std::string> counts, ids, colors, could_not_run;
    std::size_t cases = 0;

    void add(const CaseResult& result) {
        if (!is_failure(result.verdict)) return;
        ++cases;
        if (!result.counts.empty()) counts.push_back(result.name);
        if (result.ids) ids.push_back(result.name);
        if (result.colors) colors.push_back(result.name);
        if (result.verdict != Verdict::different) could_not_run.push_back(result.name);
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

/// What is not as it must be; empty where all is.
std::string shortcoming(const Expected& expected, const Caught& caught) {
    std::string text;
    const auto need = [&](bool needed, const std::vector<std::string>& names, const char* what) {
        if (needed && names.empty()) text += (text.empty() ? "" : ", ") + std::string(what);
    };
    need(expected.counts, caught.counts, "counts");
    need(expected.ids, caught.ids, "ids");
    need(expected.colors, caught.colors, "colors");
    return text.empty() ? "" : "NOT CAUGHT by " + text;
}

int run(const GoldenOptions& options, const Console& console) {
    options.check();
    const Suite suite = load_suite(options.suite);
    GoldenCheck check;
    check.cases = options.chosen(suite);
    check.settings = options.settings();
    check.jobs = options.job_count();
    const InterruptWatch watch;
    // Without a mutation nothing must differ, else nothing is proven.
    Progress progress(console, check.cases.size() * (1 + std::size(expectations)));
    const auto results = [&](const std::string& mutation) {
        const GoldenWork work;
        check.folders = {options.baselines_folder(), work.candidates(), ""};
        check.settings.mutation = mutation;
        return check_cases(check,
                           [&] {
                               progress.step("cases");
                               return watch.signal() == 0;
                           })
            .results;
    };
    for (const CaseResult& result : results(""))
        if (is_failure(result.verdict))
            throw InputError(result.name + " differs without any error: " + result.message +
                             " Mend or update that first.");
    std::string text;
    bool all_caught = true;
    for (const Expected& expected : expectations) {
        if (watch.signal() != 0) break;
        Caught caught;
        for (const CaseResult& result : results(std::string(mutation_name(expected.mutation))))
            caught.add(result);
        const std::string lacking = shortcoming(expected, caught);
        all_caught &= lacking.empty();
        text += format("%-16s caught by %zu of %zu cases%s\n",
                       std::string(mutation_name(expected.mutation)).c_str(), caught.cases,
                       check.cases.size(), lacking.empty() ? "" : (": " + lacking).c_str());
        text += "    counts  " + some_of(caught.counts) + "\n    ids     " + some_of(caught.ids) +
                "\n    colors  " + some_of(caught.colors) + "\n";
        if (!caught.could_not_run.empty())
            text += "    other   " + some_of(caught.could_not_run) + "\n";
    }
    print_result(text);
    if (watch.signal() != 0) {
        console.note("scb: interrupted; not all errors were tried.");
        return exit_interrupted(watch.signal());
    }
    return all_caught ? exit_done : exit_different;
}

}  // namespace

void add_golden_selftest(CLI::App& golden, const Console& console, Action& action) {
    CLI::App* command = golden.add_subcommand(
        "selftest", "Prove that the suite can fail: errors on purpose must turn cases red");
    const auto options = std::make_shared<GoldenOptions>();
    add_golden_options(*command, *options);
    command->footer(
        "The errors: a node dropped, a radius nudged by a thousandth, a comparison of the overlap "
        "test flipped, two of\nits stages swapped, a color shifted by 1 of 255. Each must show in "
        "counts, ids or colors, wherever it can. Exit\nstatus 1 where one does not.");
    command->callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb
