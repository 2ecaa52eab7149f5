#include <algorithm>
#include <cstdlib>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/golden/results.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "golden/report/plain_text.h"
#include "golden/run/check_cases.h"
#include "golden/run/work_folder.h"
#include "golden/suite/baseline.h"
#include "golden/suite/baseline_lock.h"
#include "scb/error.h"

namespace scb::app {
namespace {

struct UpdateOptions : GoldenOptions {
    bool failing = false, missing = false, all = false;

    void check() const;
    /// Whether a baseline is replaced after this verdict.
    bool takes(golden::Verdict verdict) const;
};

void UpdateOptions::check() const {
    GoldenOptions::check();
    const char* ci = std::getenv("CI");
    if (ci != nullptr && *ci != '\0')
        throw InputError(
            "CI is set: a run in CI must not change its own baselines; update on a machine where a "
            "person looks at the pictures.");
    if (failing + missing + all + !names.empty() != 1)
        throw InputError("which baselines? Give names of cases, or --failing, --missing or --all.");
}

bool UpdateOptions::takes(golden::Verdict verdict) const {
    if (verdict == golden::Verdict::could_not_run || verdict == golden::Verdict::skipped)
        return false;
    if (missing) return verdict == golden::Verdict::missing_baseline;
    if (failing) return golden::is_failure(verdict);
    return true;
}

/// The result of an update, perhaps interrupted.
struct Updated {
    std::string text;  ///< a line per file, or per case that could not be updated
    std::size_t cases = 0, failed = 0;
};

/// Updates the baseline of a case with this result, if asked for.
void update_case(const UpdateOptions& options, const golden::GoldenCheck& check,
                 const golden::GoldenCase& golden, const golden::CaseResult& result,
                 Updated& updated) {
    const auto fail = [&](const std::string& sentence) {
        updated.text += golden::plain_text(result.name + ": " + sentence) + "\n";
        ++updated.failed;
    };
    if (result.verdict == golden::Verdict::could_not_run && !golden::has_run(golden, check.folders))
        return fail("could not run. " + result.message);
    if (result.verdict == golden::Verdict::skipped && !options.names.empty())
        fail("skipped. " + result.message);
    // Also replace a baseline that cannot be read.
    const bool broken = result.verdict == golden::Verdict::could_not_run && !options.missing;
    if (!broken && !options.takes(result.verdict)) return;
    const std::string trouble =
        golden::record_trace(golden, check.settings, check.folders.candidates);
    if (check.settings.stopped()) return;
    if (!trouble.empty())
        fail("its trace could not be recorded, and the old one stays as it is. " + trouble);
    const std::vector<std::string> files = golden::replace_baseline(
        check.folders.baselines, check.folders.candidates, result.name,
        trouble.empty() ? golden::OldTrace::removed : golden::OldTrace::kept);
    if (files.empty()) return;
    ++updated.cases;
    for (const std::string& file : files) updated.text += golden::plain_text(file) + "\n";
}

void print(const Updated& updated, std::size_t cases) {
    print_result(updated.text + count_text(updated.cases) + " of " +
                 counted(cases, "case", "cases") + " updated\n");
}

int run(const UpdateOptions& options, const Console& console) {
    options.check();
    const golden::Suite suite = golden::load_suite(options.suite);
    const golden::GoldenWork work;
    golden::GoldenCheck check;
    check.cases = options.chosen(suite);
    check.settings = options.settings();
    check.settings.work = &work;
    check.folders = {options.baselines_folder(), work.candidates(), ""};
    check.jobs = options.job_count();
    const golden::BaselineLock lock(check.folders.baselines);
    if (lock.held()) golden::remove_unfinished(check.folders.baselines);
    const InterruptWatch watch;
    check.settings.stopped = [&watch] { return watch.signal() != 0; };
    Progress progress(console, check.cases.size());
    const std::vector<golden::CaseResult> results = golden::check_cases(check, [&] {
                                                        progress.step("cases");
                                                        return watch.signal() == 0;
                                                    }).results;

    Updated updated;
    try {
        for (const golden::CaseResult& result : results) {
            if (watch.signal() != 0) break;
            const auto golden =
                std::find_if(check.cases.begin(), check.cases.end(),
                             [&](const golden::GoldenCase& c) { return c.name == result.name; });
            update_case(options, check, *golden, result, updated);
        }
    } catch (...) {
        print(updated, results.size());
        throw;
    }
    if (options.all)
        for (const std::string& file : golden::stray_files(check.folders.baselines, suite))
            updated.text += golden::plain_text(file) +
                            ": belongs to no case; remove it by hand if it is not needed.\n";
    print(updated, results.size());
    if (watch.signal() != 0) {
        console.note("scb: interrupted; the listed cases were updated, the others not.");
        return exit_interrupted(watch.signal());
    }
    return updated.failed > 0 ? exit_different : exit_done;
}

}  // namespace

void add_golden_update(const Command& golden, const Console& console, Action& action) {
    const Command command =
        golden.add_subcommand("update", "Run cases and save the results as their baselines");
    const auto options = std::make_shared<UpdateOptions>();
    add_golden_options(command, *options);
    command.get_option("NAME").description("Cases");
    command.add_flag("--failing", options->failing, "All cases that differ or have no baseline")
        .only_typed();
    command.add_flag("--missing", options->missing, "All cases that have no baseline").only_typed();
    command.add_flag("--all", options->all, "All cases").only_typed();
    command.footer(
        "Lists the files that changed. A baseline is replaced whole or not at all. If the picture "
        "of a case changes, the\n"
        "other accepted pictures of this case are removed. An update is refused if the environment "
        "variable CI is set, or if\n"
        "another update is using the baselines.\n\n"
        "Examples:\n"
        "  scb golden update levels-spheres-scb\n"
        "  scb golden update --failing --suite my/cases.json");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
