#include "app/golden/results.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>

#include "app/cli/version.h"
#include "app/query/query_options.h"
#include "core/base/text_format.h"
#include "core/platform/input_files.h"
#include "core/platform/output_file.h"
#include "golden/compare/number_words.h"
#include "golden/report/github.h"
#include "golden/report/html_report.h"
#include "golden/report/junit.h"
#include "golden/report/plain_text.h"
#include "render/gl/context.h"
#include "scb/error.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;

std::string environment_value(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

/// The same path for all spellings of a file or folder, even if it does not exist yet.
fs::path one_name(const fs::path& path) {
    std::error_code ignored;
    // With a name behind it, a folder's path ends the same with and without a slash.
    return fs::weakly_canonical(fs::absolute(path) / "inside", ignored).parent_path();
}

/// Replaces only files that begin like results: inputs named by meshes are known only after the
/// meshes were read. An empty file does no harm.
void refuse_foreign(const fs::path& file, const std::string& option) {
    if (!is_there(file)) return;
    const bool is_json =
        option == "--json" || (option == "--report" && file.extension() == ".json");
    std::string start(64, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(stream.gcount()));
    const bool is_result = is_json ? start.starts_with('{') && start.find("\"suite\"") != start.npos
                           : option == "--junit" ? start.starts_with("<?xml")
                                                 : start.starts_with("<!doctype html>");
    if (!start.empty() && !is_result)
        throw InputError(option + " would replace " + file.string() +
                         ", which holds no results; name another place, or remove it.");
}

/// The lines of a failed case below its message. If there are too many, the last says where all
/// are.
std::string failure_text(const golden::CaseResult& c, const std::string& all_lines) {
    constexpr std::size_t most = 24;
    std::vector<std::string> commands;
    for (const std::string& command : {c.reproduce, c.diff, c.update})
        if (!command.empty()) commands.push_back(golden::plain_text(command));
    std::vector<std::string> lines = golden::result_lines(c);
    std::size_t more = 0;
    if (lines.size() + commands.size() > most) {
        const std::size_t kept = most - commands.size() - 1;
        more = lines.size() - kept;
        lines.resize(kept);
    }
    lines.insert(lines.end(), commands.begin(), commands.end());
    if (more > 0)
        lines.push_back(counted(more, "more line is", "more lines are") + " in " +
                        golden::plain_text(all_lines) + ".");
    std::string text;
    for (const std::string& line : lines) text += "    " + line + "\n";
    return text;
}

void tell_github(const golden::SuiteResult& result) {
    if (environment_value("GITHUB_ACTIONS") == "true")
        print_github_commands(golden::github_annotations(result));
    const std::string summary = environment_value("GITHUB_STEP_SUMMARY");
    if (summary.empty()) return;
    std::error_code ignored;
    refuse_input(summary, "GITHUB_STEP_SUMMARY");
    // Opening a pipe would wait for a reader.
    if (fs::exists(summary, ignored) && !is_there(summary))
        throw OutputError("Cannot write \"" + summary +
                          "\", which GITHUB_STEP_SUMMARY names: it is not a regular file; name "
                          "one.");
    std::ofstream file(summary, std::ios::app | std::ios::binary);
    file << golden::github_summary(result);
    if (!file.flush())
        throw OutputError("Cannot write \"" + summary + "\", which GITHUB_STEP_SUMMARY names.");
}

}  // namespace

std::vector<std::pair<std::string, std::string>> golden_environment(
    const golden::GoldenRunSettings& settings) {
    const auto with_compiler = [](const render::GlInfo* info) {
        auto all = versions(info);
        all.emplace_back("compiler", compiler_text());
        return all;
    };
    try {
        const render::Context context(*render::gl_backend_from_string(settings.gl));
        const render::GlInfo info = context.info();
        return with_compiler(&info);
    } catch (const render::GlError&) {
        // The cases report the error.
        return with_compiler(nullptr);
    }
}

std::vector<std::pair<std::string, fs::path>> ResultFiles::written() const {
    std::vector<std::pair<std::string, fs::path>> files;
    if (!junit.empty()) files.emplace_back("--junit", junit);
    if (!json.empty()) files.emplace_back("--json", json);
    for (const char* name : {"report.html", "results.json"})
        if (!report.empty()) files.emplace_back("--report", fs::path(report) / name);
    return files;
}

void ResultFiles::refuse_inputs() const {
    for (const auto& [option, file] : written()) {
        refuse_input(file, option);
        refuse_foreign(file, option);
    }
}

void ResultFiles::check(const fs::path& suite, const fs::path& baselines) const {
    const fs::path folder(report);
    if (!report.empty() && one_name(folder) == one_name(baselines))
        throw InputError("--report " + report +
                         ": this is the folder of the baselines, which only an update changes; "
                         "name another.");
    refuse_inputs();
    for (const auto& [option, file] : written()) {
        const fs::path name = one_name(file);
        if (name == one_name(suite) || name.parent_path() == one_name(baselines))
            throw InputError(option + " would write " + file.string() +
                             (name == one_name(suite) ? ", which is the suite"
                                                      : ", which is among the baselines") +
                             "; name another place.");
    }
}

void add_result_files(const Command& command, ResultFiles& files) {
    command
        .add_option("--report", files.report,
                    "Folder for report.html, results.json and the pictures of failing cases")
        .folder()
        .only_typed();
    command.add_option("--junit", files.junit, "Also write the results as JUnit XML")
        .file({".xml"})
        .only_typed();
    command.add_option("--json", files.json, "Also write the results as JSON")
        .file({".json"})
        .only_typed();
}

void write_results(const golden::SuiteResult& result, const ResultFiles& files,
                   const fs::path& work) {
    // Meshes may name more inputs than the suite does.
    files.refuse_inputs();
    std::optional<OutputError> failed;
    // If one output fails, for example the terminal, still write the others.
    const auto attempt = [&](auto write) {
        try {
            write();
        } catch (const OutputError& error) {
            if (!failed) failed = error;
        }
    };
    attempt([&] { print_result(results_text(result, files.with_all_lines())); });
    if (!files.report.empty())
        attempt([&] { golden::write_report_folder(result, files.report, work); });
    if (!files.junit.empty())
        attempt([&] { write_file_whole(files.junit, golden::junit_xml(result)); });
    if (!files.json.empty())
        attempt([&] { write_file_whole(files.json, golden::results_json(result)); });
    attempt([&] { tell_github(result); });
    if (failed) throw *failed;
}

std::string ResultFiles::with_all_lines() const {
    if (!report.empty()) return (fs::path(report) / "report.html").string();
    if (!json.empty()) return json;
    if (!junit.empty()) return junit;
    return "the page that --report DIR writes";
}

std::string results_text(const golden::SuiteResult& result, const std::string& all_lines) {
    std::string text;
    std::map<golden::Verdict, std::size_t> counts;
    std::size_t tolerated = 0;
    for (const golden::CaseResult& c : result.cases) {
        ++counts[c.verdict];
        tolerated += golden::is_tolerated(c);
        if (c.verdict == golden::Verdict::same) {
            for (const std::string& line : c.lines)
                text += golden::plain_text(c.name + ": same. " + line) + "\n";
            continue;
        }
        text += golden::plain_text(c.name) + ": " + std::string(golden::verdict_names[c.verdict]) +
                ". " + golden::plain_text(golden::first_words(c)) + "\n" +
                failure_text(c, all_lines);
    }
    if (!result.incomplete.empty())
        text += "incomplete. " + golden::plain_text(result.incomplete) + "\n";
    text += counted(result.cases.size(), "case", "cases");
    if (result.cases.empty() && !result.shard.empty())
        text += "; none are left for shard " + golden::plain_text(result.shard);
    const char* separator = ": ";
    for (const auto& [verdict, count] : counts) {
        text +=
            separator + std::to_string(count) + " " + std::string(golden::verdict_names[verdict]);
        if (verdict == golden::Verdict::same && tolerated > 0)
            text += " (" + std::to_string(tolerated) + " within the tolerance)";
        separator = ", ";
    }
    return text + "\n";
}

}  // namespace scb::app
