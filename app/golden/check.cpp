#include <algorithm>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/golden/case_views.h"
#include "app/golden/commands.h"
#include "app/golden/results.h"
#include "app/query/query_options.h"
#include "core/base/exit_status.h"
#include "core/platform/shard.h"
#include "golden/run/check_cases.h"
#include "golden/run/work_folder.h"
#include "golden/suite/baseline.h"
#include "scb/error.h"

namespace scb::app {
namespace {

struct CheckOptions : GoldenOptions {
    std::string shard;
    ResultFiles files;
    bool trace = false;
};

std::vector<golden::GoldenCase> cases_of(const CheckOptions& options, const golden::Suite& suite) {
    std::vector<golden::GoldenCase> cases = options.chosen(suite);
    if (cases.empty())
        throw InputError(options.suite +
                         ": there is no case to check; add some, or name another file with "
                         "--suite.");
    if (options.shard.empty()) return cases;
    const Shard shard = parse_shard(options.shard);
    std::vector<golden::GoldenCase> mine;
    for (std::size_t i = 0; i < cases.size(); ++i)
        if (in_shard(shard, i)) mine.push_back(std::move(cases[i]));
    return mine;
}

int run(const CheckOptions& options, const Console& console) {
    options.check();
    if (options.trace && options.files.report.empty())
        throw InputError(
            "--trace: traces are kept in the folder of the report; name one with --report DIR.");
    const golden::Suite suite = golden::load_suite(options.suite);
    golden::check_readable(options.baselines_folder());
    const golden::GoldenWork work;
    golden::GoldenCheck check;
    check.cases = cases_of(options, suite);
    options.files.check(options.suite, options.baselines_folder());
    check.settings = options.settings();
    check.settings.work = &work;
    check.folders = {options.baselines_folder(), work.candidates(), work.report()};
    check.jobs = options.job_count();
    check.traces = options.trace;

    golden::SuiteResult result;
    result.suite = options.suite;
    result.shard = options.shard;
    const InterruptWatch watch;
    check.settings.stopped = [&watch] { return watch.signal() != 0; };
    Progress progress(console, check.cases.size());
    const golden::CheckedCases checked = golden::check_cases(check, [&] {
        progress.step("cases");
        return watch.signal() == 0;
    });
    result.cases = checked.results;
    for (golden::CaseResult& c : result.cases)
        golden::complete_result(c, case_of(c.name, check.cases), check.folders);
    if (result.cases.size() < check.cases.size())
        result.incomplete = "The run was interrupted: " + std::to_string(result.cases.size()) +
                            " of " + std::to_string(check.cases.size()) + " cases were checked.";
    result.environment = golden_environment(check.settings);
    add_commands(result, check, options);
    add_diff_commands(result, options.files.report);
    add_views(result, work.report(), options, console, [&watch] { return watch.signal() == 0; });
    write_results(result, options.files, work.report());
    for (const std::string& file : golden::uncompared_images(check.folders.baselines, suite))
        console.note("scb: " + (check.folders.baselines / file).string() + " " + why_uncompared);
    if (golden::has_failed(result) && options.files.report.empty())
        console.note("scb: --report DIR writes a page that shows what differs.");
    if (!options.files.report.empty())
        console.note("scb: the report is " +
                     (std::filesystem::path(options.files.report) / "report.html").string() + ".");
    if (watch.signal() != 0) return exit_interrupted(watch.signal());
    const auto failures =
        std::count_if(result.cases.begin(), result.cases.end(),
                      [](const golden::CaseResult& c) { return golden::is_failure(c.verdict); });
    if (failures == 0) return exit_done;
    return static_cast<std::size_t>(failures) == checked.lacked_gl ? exit_no_gl : exit_different;
}

}  // namespace

void add_golden_check(const Command& golden, const Console& console, Action& action) {
    const Command command =
        golden.add_subcommand("check", "Run the cases and compare them with their baselines");
    const auto options = std::make_shared<CheckOptions>();
    add_golden_options(command, *options);
    command
        .add_option(
            "--shard", options->shard,
            "Run part K of N: every N-th case, starting with case K. Give each machine its own K")
        .type_name("K/N");
    add_result_files(command, options->files);
    command.add_flag(
        "--trace", options->trace,
        "Keep the traces of failing cases in the folder of the report, with a page of `scb "
        "view` for each");
    command.footer(
        "Compares counts, then ids (which node, triangle or pair owns each pixel), then colors. "
        "All must be equal; a case\n"
        "can set a tolerance for colors. Exit status: 1 if a case differs, has no baseline or "
        "could not run; 77 if there is\n"
        "no OpenGL context and nothing else failed. See golden/README.md.\n\n"
        "Examples:\n"
        "  scb golden check\n"
        "  scb golden check --report out/ --junit out/junit.xml\n"
        "  scb golden check --suite my/cases.json --baselines my/baselines --shard 2/4");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
