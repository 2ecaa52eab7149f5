#include "golden/run/check_cases.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/platform/file_bytes.h"
#include "core/platform/json_reader.h"
#include "core/platform/output_file.h"
#include "golden/run/failure_lines.h"
#include "golden/suite/baseline.h"
#include "golden/suite/file_replacement.h"
#include "render/files/image_file.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

/// Keeps both traces beside the report.
void keep_traces(CaseResult& result, const ComparisonFolders& folders) {
    const auto keep = [&](const fs::path& folder, const char* kind) {
        const fs::path from = trace_of(case_files(folder, result.name));
        if (from.empty()) return;
        std::error_code error;
        const std::string name = result.name + "." + kind + from.extension().string();
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
    } catch (const OutputError&) {
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
        const bool before = !trace_of(case_files(check.folders.baselines, golden.name)).empty();
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
    return is_there(made.meta) && is_there(made.counts) &&
           (!golden.colors || is_there(made.image)) && (!golden.ids || is_there(made.ids));
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

void for_each_in_threads(std::size_t count, std::size_t threads,
                         const std::function<void(std::size_t)>& work,
                         const std::function<bool()>& step) {
    std::atomic<std::size_t> next = 0;
    std::mutex stepping;
    std::exception_ptr error;
    const auto run = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                work(i);
                const std::lock_guard lock(stepping);
                if (!step()) next = count;
            } catch (...) {
                const std::lock_guard lock(stepping);
                if (!error) error = std::current_exception();
                next = count;
                return;
            }
        }
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < threads && i < count; ++i) others.emplace_back(run);
        run();
    }
    if (error) std::rethrow_exception(error);
}

namespace {

namespace fs = std::filesystem;

/// Copies a picture of the run for the report, if it is not there yet.
void show(std::string& candidate, const fs::path& made, const fs::path& report,
          const std::string& name) {
    if (!candidate.empty() || report.empty() || !is_there(made)) return;
    write_file_whole(report / name, file_bytes(made.string()));
    candidate = name;
}

void add_pictures(CaseResult& result, const CaseFiles& made, const fs::path& report, bool ids,
                  bool colors) {
    if (colors) show(result.picture.candidate, made.image, report, result.name + ".new.png");
    if (ids) show(result.id_picture.candidate, made.ids, report, result.name + ".new.ids.png");
}

void add_counts(CaseResult& result, const fs::path& made) {
    const std::string file = made.string();
    const std::vector<CountChange> counts =
        counts_difference(nlohmann::json::object(), parse_json(read_text_file(file), file));
    result.counts.insert(result.counts.begin(), counts.begin(), counts.end());
}

void add_tolerated_colors(CaseResult& result, const GoldenCase& golden,
                          const ComparisonFolders& folders, const CaseFiles& made) {
    if (!golden.colors || golden.tolerance == ColorTolerance{} || result.variant == 0) return;
    const fs::path accepted = accepted_images(
        folders.baselines, result.name)[static_cast<std::size_t>(result.variant) - 1];
    if (files_equal(accepted, made.image)) return;
    const ImageDifference difference =
        image_difference(render::read_png(accepted), render::read_png(made.image));
    if (difference.pixels > 0) result.colors = difference;
}

}  // namespace

void complete_result(CaseResult& result, const GoldenCase& golden,
                     const ComparisonFolders& folders) {
    if (!has_run(golden, folders)) return;
    const CaseFiles before = case_files(folders.baselines, result.name),
                    made = case_files(folders.candidates, result.name);
    if (result.verdict == Verdict::same) return add_tolerated_colors(result, golden, folders, made);
    if (result.verdict == Verdict::could_not_run) {
        result.message +=
            " Restore it from version control, or take over what the run made with the command "
            "below.";
        return add_pictures(result, made, folders.report, golden.ids, golden.colors);
    }
    if (golden.counts && !is_there(before.counts)) add_counts(result, made.counts);
    add_pictures(result, made, folders.report, golden.ids && !is_there(before.ids),
                 golden.colors && !is_there(before.image));
}

}  // namespace scb::golden
