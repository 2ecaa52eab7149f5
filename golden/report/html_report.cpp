#include "golden/report/html_report.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "core/base/text_format.h"
#include "core/platform/file_bytes.h"
#include "core/platform/input_files.h"
#include "core/platform/json_reader.h"
#include "core/platform/output_file.h"
#include "golden/report/report_values.h"
#include "golden/suite/case_command.h"
#include "render/gl/embedded.h"
#include "scb/error.h"

SCB_DECLARE_EMBEDDED(report_html)
SCB_DECLARE_EMBEDDED(report_css)
SCB_DECLARE_EMBEDDED(report_js)

namespace scb::golden {
namespace {

namespace fs = std::filesystem;
using kainjow::mustache::data;
using kainjow::mustache::mustache;
using report::flag;

constexpr std::array verdicts = {
    Verdict::different,     Verdict::size_differs, Verdict::missing_baseline, Verdict::new_output,
    Verdict::could_not_run, Verdict::same,         Verdict::skipped,
};

/// A longer text is folded away.
constexpr std::size_t most_open_lines = 8;

/// For ids of elements and the links to them.
std::string anchor_of(const std::string& name, std::set<std::string>& taken) {
    std::string anchor = "case-";
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
        anchor += plain ? c : '_';
    }
    const std::string first = anchor;
    for (int i = 2; !taken.insert(anchor).second; ++i) anchor = first + "~" + std::to_string(i);
    return anchor;
}

/// The update command without the name, so that the page can put several names behind it; empty if
/// there is none.
std::string update_prefix(const CaseResult& result) {
    const std::string name = " " + shell_word(result.name);
    if (!result.update.ends_with(name)) return "";
    return result.update.substr(0, result.update.size() - name.size());
}

std::string seconds_text(double seconds) { return format("%.*f s", seconds < 10 ? 2 : 0, seconds); }

/// Lines from traces are first; if many things have changed pixels, their lines are folded away.
void set_lines(data& values, const std::vector<std::string>& all) {
    data lines(data::type::list), more(data::type::list);
    const std::size_t open = all.size() <= most_open_lines + 2 ? all.size() : most_open_lines;
    for (std::size_t i = 0; i < all.size(); ++i) {
        data entry;
        entry["line"] = all[i];
        (i < open ? lines : more) << entry;
    }
    values["has_lines"] = flag(!all.empty());
    values.set("lines", lines);
    values["has_more_lines"] = flag(all.size() > open);
    values["more_lines_words"] = counted(all.size() - open, "more line", "more lines");
    values.set("more_lines", more);
}

void set_commands(data& values, const CaseResult& result) {
    data commands(data::type::list);
    const auto add = [&](const char* title, const std::string& text) {
        if (text.empty()) return;
        data command;
        command["title"] = title;
        command["text"] = text;
        commands << command;
    };
    add("Reproduce", result.reproduce);
    add("Compare the traces", result.diff);
    add("Update, if the change is right", result.update);
    values["has_commands"] = flag(!commands.is_empty_list());
    values.set("commands", commands);
}

data failure_of(const CaseResult& result, const fs::path& folder, std::set<std::string>& anchors) {
    data values;
    values["name"] = result.name;
    values["anchor"] = anchor_of(result.name, anchors);
    values["verdict"] = std::string(verdict_names[result.verdict]);
    values["cause"] = result.cause;
    values["has_cause"] = flag(!result.cause.empty());
    values["message"] = result.message;
    values["has_message"] = flag(!result.message.empty());
    values["seconds"] = seconds_text(result.seconds);
    values["variant"] = std::to_string(result.variant);
    values["has_variant"] = flag(result.variant > 1);
    set_lines(values, result.lines);

    const auto trace_lines = static_cast<std::size_t>(
        std::count(result.trace_difference.begin(), result.trace_difference.end(), '\n'));
    values["trace"] = result.trace_difference;
    const bool has_page = !result.view.empty() && !result.view.starts_with('#');
    values["has_view"] = flag(has_page);
    if (has_page) values["view"] = result.view;
    values["has_short_trace"] = flag(trace_lines > 0 && trace_lines <= most_open_lines);
    values["has_long_trace"] = flag(trace_lines > most_open_lines);
    values["trace_words"] = counted(trace_lines, "line", "lines");

    const data sets = report::pictures_of(result, folder);
    values["has_pictures"] = flag(!sets.is_empty_list());
    values["two_sets"] = flag(sets.list_value().size() > 1);
    values.set("sets", sets);

    report::set_tables(values, result, folder);
    set_commands(values, result);
    const std::string prefix = update_prefix(result);
    values["can_update"] = flag(!prefix.empty());
    values["update_prefix"] = prefix;
    values["update_name"] = shell_word(result.name);
    return values;
}

/// Cases that need one line only: passed or skipped.
data brief_of(const CaseResult& result) {
    data values;
    values["name"] = result.name;
    values["message"] = result.message;
    values["has_message"] =
        flag(result.verdict == Verdict::skipped ? !result.message.empty() : false);
    values["variant"] = std::to_string(result.variant);
    values["has_variant"] = flag(result.variant > 1);
    values["is_tolerated"] = flag(is_tolerated(result));
    if (is_tolerated(result))
        values["tolerated"] = counted(result.colors->pixels, "pixel differs", "pixels differ") +
                              ", by up to " + std::to_string(result.colors->largest) + " of 255";
    return values;
}

void set_header(data& values, const SuiteResult& result, std::size_t failures) {
    const std::size_t all = result.cases.size();
    values["failed"] = flag(has_failed(result));
    values["incomplete"] = result.incomplete;
    values["has_incomplete"] = flag(!result.incomplete.empty());
    if (all == 0)
        values["headline"] = "No cases were run";
    else if (failures > 0)
        values["headline"] =
            count_text(failures) + " of " + counted(all, "case", "cases") + " failed";
    else
        values["headline"] = counted(all, "case", "cases") +
                             (result.incomplete.empty() ? ", none failed" : ", but not all");
    values["suite"] = result.suite;
    values["shard"] = result.shard;
    values["has_shard"] = flag(!result.shard.empty());
    data chips(data::type::list);
    for (const Verdict verdict : verdicts) {
        const auto n = std::count_if(result.cases.begin(), result.cases.end(),
                                     [&](const CaseResult& c) { return c.verdict == verdict; });
        if (n == 0) continue;
        data chip;
        chip["verdict"] = std::string(verdict_names[verdict]);
        chip["n"] = count_text(static_cast<std::uint64_t>(n));
        chips << chip;
    }
    values.set("chips", chips);
    data environment(data::type::list);
    for (const auto& [name, value] : result.environment) {
        data entry;
        entry["name"] = name;
        entry["value"] = value;
        environment << entry;
    }
    values["has_environment"] = flag(!result.environment.empty());
    values.set("environment", environment);
}

}  // namespace

std::string report_html(const SuiteResult& result, const fs::path& folder) {
    data failures(data::type::list), passed(data::type::list), skipped(data::type::list);
    std::set<std::string> anchors;
    std::size_t failed = 0, same = 0, left_out = 0;
    for (const Verdict verdict : verdicts)
        for (const CaseResult& c : result.cases) {
            if (c.verdict != verdict) continue;
            if (is_failure(verdict)) {
                failures << failure_of(c, folder, anchors);
                ++failed;
            } else if (verdict == Verdict::skipped) {
                skipped << brief_of(c);
                ++left_out;
            } else {
                passed << brief_of(c);
                ++same;
            }
        }
    data values;
    values["style"] = std::string(SCB_EMBEDDED(report_css));
    values["script"] = std::string(SCB_EMBEDDED(report_js));
    set_header(values, result, failed);
    values["has_failures"] = flag(failed > 0);
    values["many_failures"] = flag(failed > 1);
    values["failures_words"] = counted(failed, "failure", "failures");
    values.set("failures", failures);
    values["has_passed"] = flag(same > 0);
    const auto tolerated = static_cast<std::size_t>(
        std::count_if(result.cases.begin(), result.cases.end(), is_tolerated));
    values["passed_words"] =
        counted(same, "case is", "cases are") + " the same" +
        (tolerated > 0 ? ", " + count_text(tolerated) + " of them within the tolerance" : "");
    values.set("passed", passed);
    values["has_skipped"] = flag(left_out > 0);
    values["skipped_words"] = counted(left_out, "case was", "cases were") + " skipped";
    values.set("skipped", skipped);
    mustache html{std::string(SCB_EMBEDDED(report_html))};
    assert(html.is_valid() && "the template is part of the program");
    return html.render(values);
}

namespace {

namespace fs = std::filesystem;

/// The path of a file of the report. Refuses a pipe, which would wait for a reader.
fs::path place_of(const fs::path& folder, const fs::path& name) {
    const fs::path place = folder / name;
    refuse_input(place, "--report " + folder.string());
    std::error_code ignored;
    if (fs::exists(place, ignored) && !is_there(place))
        throw OutputError(
            place.string() +
            ": there is something of that name that is not a file; remove it, or name "
            "another folder with --report.");
    return place;
}

void clear_report(const fs::path& folder) {
    const std::string list = (folder / "results.json").string();
    std::error_code ignored;
    if (!fs::exists(list, ignored)) return;
    SuiteResult old;
    try {
        old = result_of(parse_json(read_text_file(list, std::size_t{1} << 30), list), list);
    } catch (const InputError&) {
        return;  // it is not a list of a report's files
    }
    for (const CaseResult& c : old.cases)
        for (const std::string& name : files_of(c))
            if (fs::path(name).filename() == name) fs::remove(place_of(folder, name), ignored);
    fs::remove(folder / "report.html", ignored);
    fs::remove(list, ignored);
}

}  // namespace

void write_report_folder(const SuiteResult& result, const fs::path& folder, const fs::path& work) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw OutputError(folder.string() + ": this folder cannot be made (" + error.message() +
                          "); name another with --report.");
    clear_report(folder);
    for (const fs::directory_entry& entry : fs::directory_iterator(work))
        write_file_whole(place_of(folder, entry.path().filename()),
                         file_bytes(entry.path().string()));
    write_file_whole(place_of(folder, "report.html"), report_html(result, work));
    write_file_whole(place_of(folder, "results.json"), results_json(result));
}

std::string results_json(const SuiteResult& result) {
    using Json = nlohmann::ordered_json;
    return result_json(result).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace scb::golden
