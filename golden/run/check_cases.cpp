#include "golden/run/check_cases.h"

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <thread>

#include "golden/run/failure_lines.h"
#include "golden/run/for_each_in_threads.h"
#include "golden/suite/baseline.h"
#include "render/files/output_file.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

/// Keeps both traces beside the report.
void keep_traces(CaseResult& result, const ComparisonFolders& folders) {
    const auto keep = [&](const fs::path& folder, const char* kind) {
        const fs::path from = case_files(folder, result.name).trace;
        if (!render::is_there(from)) return;
        std::error_code error;
        const std::string name = result.name + "." + kind + ".scbtrace";
        fs::copy_file(from, folders.report / name, fs::copy_options::overwrite_existing, error);
        if (!error) result.traces.push_back(name);
    };
    keep(folders.baselines, "baseline");
    keep(folders.candidates, "new");
}

struct CheckedCase {
    CaseResult result;
    bool lacked_gl = false;
};

/// An error of one case does not end the check of the others, unless nothing can be written.
CaseResult compared(const GoldenCase& golden, const ComparisonFolders& folders) {
    try {
        return compare_case(golden, folders);
    } catch (const render::OutputError&) {
        throw;
    } catch (const std::exception& error) {
        CaseResult result;
        result.name = golden.name;
        result.verdict = Verdict::could_not_run;
        result.message =
            "The comparison with the baseline failed: " + std::string(error.what()) + ".";
        return result;
    }
}

/// Nothing if it was stopped.
std::optional<CheckedCase> check_case(const GoldenCase& golden, const GoldenCheck& check) {
    const GoldenRunEnd run = run_case(golden, check.settings, check.folders.candidates);
    if (run.stopped) return std::nullopt;
    CheckedCase checked{{}, run.lacked_gl};
    CaseResult& result = checked.result;
    if (run.ran) {
        result = compared(golden, check.folders);
    } else {
        result.name = golden.name;
        result.verdict = run.skipped ? Verdict::skipped : Verdict::could_not_run;
        result.message = run.message;
    }
    result.seconds = run.seconds;
    if (result.verdict == Verdict::different) {
        const bool before =
            render::is_there(case_files(check.folders.baselines, golden.name).trace);
        const std::string trouble =
            before || check.traces ? record_trace(golden, check.settings, check.folders.candidates)
                                   : "";
        if (!trouble.empty())
            result.lines.push_back("The trace of this run could not be recorded: " + trouble);
        if (check.traces && !check.folders.report.empty()) keep_traces(result, check.folders);
    }
    add_lines(result, golden, check.settings, check.folders);
    return checked;
}

/// The order in which cases run: a worker keeps the hierarchies of the scene that it ran last.
class CaseOrder {
  public:
    explicit CaseOrder(const std::vector<GoldenCase>& cases) : cases_(cases), left_(cases.size()) {
        std::iota(left_.begin(), left_.end(), std::size_t{0});
    }

    /// A case of the scene that the calling thread ran last; else of a scene that no other thread
    /// runs; else any.
    std::size_t next() {
        const std::lock_guard lock(mutex_);
        std::vector<std::string>& own = latest_[std::this_thread::get_id()];
        auto found = std::find_if(left_.begin(), left_.end(),
                                  [&](std::size_t i) { return cases_[i].scene == own; });
        if (found == left_.end())
            found = std::find_if(left_.begin(), left_.end(), [&](std::size_t i) {
                return std::none_of(latest_.begin(), latest_.end(), [&](const auto& latest) {
                    return latest.second == cases_[i].scene;
                });
            });
        if (found == left_.end()) found = left_.begin();
        const std::size_t i = *found;
        left_.erase(found);
        own = cases_[i].scene;
        return i;
    }

  private:
    const std::vector<GoldenCase>& cases_;
    std::vector<std::size_t> left_;
    std::map<std::thread::id, std::vector<std::string>> latest_;
    std::mutex mutex_;
};

}  // namespace

bool has_run(const GoldenCase& golden, const ComparisonFolders& folders) {
    const CaseFiles made = case_files(folders.candidates, golden.name);
    return render::is_there(made.meta) && render::is_there(made.counts) &&
           (!golden.colors || render::is_there(made.image)) &&
           (!golden.ids || render::is_there(made.ids));
}

CheckedCases check_cases(const GoldenCheck& check, const std::function<bool()>& step) {
    std::vector<std::optional<CheckedCase>> done(check.cases.size());
    CaseOrder order(check.cases);
    for_each_in_threads(
        check.cases.size(), check.jobs,
        [&](std::size_t) {
            const std::size_t i = order.next();
            done[i] = check_case(check.cases[i], check);
        },
        step);
    CheckedCases all;
    for (std::size_t i = 0; i < done.size(); ++i) {
        if (!done[i]) continue;
        all.lacked_gl += done[i]->lacked_gl;
        all.results.push_back(std::move(done[i]->result));
    }
    return all;
}

}  // namespace scb::golden
