#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/golden/commands.h"
#include "app/golden/results.h"
#include "app/query/query_options.h"
#include "core/base/exit_status.h"
#include "core/platform/file_bytes.h"
#include "core/platform/input_files.h"
#include "core/platform/json_reader.h"
#include "core/platform/output_file.h"
#include "golden/report/merge.h"
#include "golden/run/work_folder.h"
#include "scb/error.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
    std::vector<std::string> from;
    ResultFiles files;
};

/// Copies the files of a result into the work folder, so that one report can have results of
/// several folders.
void gather(const golden::CaseResult& result, const fs::path& folder, const fs::path& work) {
    for (const std::string& name : golden::files_of(result)) {
        // Results may come from elsewhere: accept names, not paths.
        if (fs::path(name).filename() != name)
            throw InputError((folder / "results.json").string() + ": '" + name +
                             "' is not a name of a file beside it.");
        std::error_code ignored;
        note_input(folder / name);
        if (fs::exists(folder / name, ignored))
            write_file_whole(work / name, file_bytes((folder / name).string()));
    }
}

int run(const ReportOptions& options, const Console& console) {
    const golden::GoldenWork work;
    std::vector<golden::ResultPart> parts;
    for (const std::string& file : options.from) note_input(file);
    options.files.refuse_inputs();
    for (const std::string& file : options.from)
        parts.push_back(
            {file, golden::result_of(parse_json(read_text_file(file, std::size_t{1} << 30), file),
                                     file)});
    golden::SuiteResult merged = golden::merge_results(parts);
    if (!options.files.report.empty()) add_diff_commands(merged, options.files.report);
    for (const golden::ResultPart& part : parts)
        for (const golden::CaseResult& c : part.result.cases)
            gather(c, fs::path(part.file).parent_path(), work.report());
    write_results(merged, options.files, work.report());
    if (!options.files.report.empty())
        console.note("scb: the report is " +
                     (fs::path(options.files.report) / "report.html").string() + ".");
    return golden::has_failed(merged) ? exit_different : exit_done;
}

}  // namespace

void add_golden_report(const Command& golden, const Console& console, Action& action) {
    const Command command = golden.add_subcommand(
        "report", "Make one report of the results of one run or of several shards");
    const auto options = std::make_shared<ReportOptions>();
    command
        .add_option("--from", options->from,
                    "The results.json of each shard; the pictures must be in the same folder")
        .required()
        .expected(1, 1000)
        .file({".json"})
        .type_name("FILE.json...");
    add_result_files(command, options->files);
    command.footer(
        "Exit status as of `scb golden check`; also 1 if a shard is missing or was interrupted, or "
        "no case was checked.\n\n"
        "Example:\n"
        "  scb golden report --from shard-1/results.json shard-2/results.json --report out/");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
