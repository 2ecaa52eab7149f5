#include "golden/report/github.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>
#include <vector>

#include "core/base/text_format.h"
#include "golden/report/plain_text.h"

namespace scb::golden {
namespace {

constexpr std::size_t most_annotations = 10, most_annotated_lines = 16, most_summary_lines = 30;

/// Longer sentences and lines are cut; in a summary, names and sentences have smaller limits.
constexpr std::size_t longest_text = 2000, longest_name = 100, longest_sentence = 300;

using Cases = std::vector<const CaseResult*>;

Cases failing_cases(const SuiteResult& result) {
    Cases failing;
    for (const CaseResult& one : result.cases)
        if (is_failure(one.verdict)) failing.push_back(&one);
    return failing;
}

std::string cases_text(std::size_t count) { return counted(count, "case", "cases"); }

/// The text, cut between characters if it is too long.
std::string shortened(std::string_view text, std::size_t most = longest_text) {
    if (text.size() <= most) return std::string(text);
    std::size_t size = most;
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xc0) == 0x80) --size;
    return std::string(text.substr(0, size)) + "...";
}

std::string escaped(std::string_view text, std::string_view special) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string result;
    for (const char c : text) {
        if (special.find(c) == std::string_view::npos) {
            result += c;
            continue;
        }
        const auto byte = static_cast<unsigned char>(c);
        result += {'%', digits[byte >> 4], digits[byte & 15]};
    }
    return result;
}

/// The two kinds of text in a workflow command ("Workflow commands for GitHub Actions"; toolkit,
/// packages/core/src/command.ts).
std::string command_data(std::string_view text) { return escaped(text, "%\r\n"); }
std::string command_property(std::string_view text) { return escaped(text, "%\r\n:,"); }

std::string annotation(const std::string& title, const std::string& message) {
    return "::error title=" + command_property(shortened(plain_text(title))) +
           "::" + command_data(message) + "\n";
}

/// At most `most` lines of a case, each behind a line end, and the number of further lines.
std::string lines_text(const CaseResult& result, std::size_t most) {
    const std::vector<std::string> lines = result_lines(result);
    std::string text;
    for (std::size_t i = 0; i < lines.size() && i < most; ++i) text += "\n" + shortened(lines[i]);
    if (lines.size() > most)
        text += "\n... and " + counted(lines.size() - most, "more line", "more lines");
    return text;
}

std::string annotation_of(const CaseResult& result) {
    return annotation(
        result.name + " (" + std::string(verdict_names[result.verdict]) + ")",
        shortened(plain_text(first_words(result))) + lines_text(result, most_annotated_lines));
}

/// Text that Markdown shows literally, on one line, cut if it is too long.
std::string markdown(std::string_view text, std::size_t most) {
    std::string result;
    for (const char c : shortened(plain_text(text), most)) {
        if (std::string_view("\\`*_[]<>|~#&$!").find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

/// A block of code; its fence is longer than any row of backticks in it.
std::string code_block(std::string_view language, std::string_view text) {
    std::size_t longest = 0, row = 0;
    for (const char c : text) {
        row = c == '`' ? row + 1 : 0;
        longest = std::max(longest, row);
    }
    const std::string fence(std::max<std::size_t>(3, longest + 1), '`');
    return fence + std::string(language) + "\n" + std::string(text) + fence + "\n\n";
}

std::string section_of(const CaseResult& result) {
    std::string section = "### " + markdown(result.name, longest_name) + "\n\n**" +
                          std::string(verdict_names[result.verdict]) +
                          "**: " + markdown(first_words(result), longest_sentence) + "\n\n";
    const std::string lines = lines_text(result, most_summary_lines);
    if (!lines.empty()) section += code_block("", lines.substr(1) + "\n");
    std::string commands;
    for (const std::string& command : {result.reproduce, result.diff, result.update})
        if (!command.empty()) commands += plain_text(command) + "\n";
    return commands.empty() ? section : section + code_block("sh", commands);
}

std::string verdict_table(const SuiteResult& result) {
    std::array<std::size_t, static_cast<std::size_t>(Verdict::skipped) + 1> counts{};
    for (const CaseResult& one : result.cases) ++counts[static_cast<std::size_t>(one.verdict)];
    std::string table = "| verdict | cases |\n| --- | ---: |\n";
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 0)
            table += "| " + std::string(verdict_names[static_cast<Verdict>(i)]) + " | " +
                     std::to_string(counts[i]) + " |\n";
    return table + "\n";
}

}  // namespace

std::string github_annotations(const SuiteResult& result) {
    const Cases failing = failing_cases(result);
    std::string text;
    std::size_t most = most_annotations;
    if (!result.incomplete.empty()) {
        text += annotation("incomplete", shortened(plain_text(result.incomplete)));
        --most;
    }
    const std::size_t shown = failing.size() > most ? most - 1 : failing.size();
    for (std::size_t i = 0; i < shown; ++i) text += annotation_of(*failing[i]);
    if (shown == failing.size()) return text;
    std::string names;
    for (std::size_t i = shown; i < failing.size(); ++i)
        names += (names.empty() ? "" : ", ") + failing[i]->name;
    return text + annotation(std::to_string(failing.size() - shown) + " more cases",
                             shortened(plain_text(names)));
}

std::string github_summary(const SuiteResult& result, std::size_t largest) {
    assert(largest >= 4096 && "the heading, the table and a last sentence need room");
    const Cases failing = failing_cases(result);
    std::string text = "## Golden: ";
    text += has_failed(result) ? std::to_string(failing.size()) + " of " +
                                     cases_text(result.cases.size()) + " failed"
                               : "nothing differs";
    if (!result.shard.empty()) text += ", shard " + markdown(result.shard, longest_name);
    text += "\n\n";
    if (!result.incomplete.empty())
        text += "**incomplete**: " + markdown(result.incomplete, longest_sentence) + "\n\n";
    text += verdict_table(result);
    constexpr std::size_t last_sentence = 200;
    for (std::size_t i = 0; i < failing.size(); ++i) {
        const std::string section = section_of(*failing[i]);
        if (text.size() + section.size() + last_sentence > largest)
            return text + cases_text(failing.size() - i) +
                   " more failed; the report has all of them.\n";
        text += section;
    }
    return text;
}

}  // namespace scb::golden
