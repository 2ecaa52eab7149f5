#include "app/reference/markdown_page.h"

#include <algorithm>

#include "app/reference/help_footer.h"
#include "app/reference/synopsis.h"
#include "app/reference/words.h"

namespace scb::app {
namespace {

using Section = FooterPart::Section;

/// Text that Markdown prints as it is, in a cell of a table too. Words between backticks are code.
std::string markdown(const std::string& text) {
    std::string result;
    bool in_code = false;
    for (const char c : text) {
        if (c == '`') in_code = !in_code;
        const char* const special = in_code ? "|" : "|\\*<>[]";
        if (std::string_view(special).find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

std::string code(const std::string& text) { return "`" + text + "`"; }
std::string unchanged(const std::string& text) { return text; }

std::string markdown_sentence(const std::string& text) {
    return markdown(text) + (text.empty() || text.ends_with('.') ? "" : ".");
}

std::string link(const ReferenceCommand& command) {
    std::string anchor = command.name;
    std::replace(anchor.begin(), anchor.end(), ' ', '-');
    return "[" + code(command.name) + "](#" + anchor + ")";
}

std::string row(const std::string& left, const std::string& right) {
    return "| " + left + " | " + right + " |\n";
}

std::string table(const std::string& title, const std::string& rows) {
    return rows.empty() ? "" : "\n" + row(title, "meaning") + "|---|---|\n" + rows;
}

/// The words that can be given, where help does not have them.
std::string values_text(const ReferenceOption& option) {
    const auto is_in_help = [&](const std::string& word) {
        return option.help.find(word) != std::string::npos;
    };
    const std::vector<std::string>& words = option.values.words;
    if (option.names.empty() || std::all_of(words.begin(), words.end(), is_in_help)) return "";
    return " Values: " + code(joined(words, "`, `")) + ".";
}

std::string option_row(const ReferenceOption& option) {
    std::string text = markdown_sentence(option.help) + values_text(option);
    if (option.is_required && !option.names.empty()) text += " Must be given.";
    if (!option.default_text.empty()) text += " Default: " + code(option.default_text) + ".";
    if (!option.environment.empty())
        text += " The environment variable " + code(option.environment) + " does the same.";
    return row(markdown(code(option_heading(option, unchanged, unchanged))), text);
}

/// The paragraphs of a section of a help's footer.
std::string paragraphs(const std::string& footer, Section section) {
    std::string text;
    for (FooterPart part : footer_parts(footer, section)) {
        if (part.is_literal)
            for (std::string& line : part.lines) line = code(line);
        const std::string lines = joined(part.lines, part.is_literal ? "\\\n" : "\n");
        text += std::string("\n") + (section == Section::statuses ? "Exit status: " : "") +
                (part.is_literal ? lines : markdown(lines)) + "\n";
    }
    return text;
}

/// The command, and all below it. Options and footers of the command above are not repeated.
std::string command_sections(const ReferenceCommand& command, const ReferenceCommand* above) {
    std::string arguments, options, commands;
    for (const ReferenceOption& argument : command.arguments) arguments += option_row(argument);
    for (const ReferenceOption& option : command.options) {
        const auto is_same = [&](const ReferenceOption& o) { return o.names == option.names; };
        if (above == nullptr || std::none_of(above->options.begin(), above->options.end(), is_same))
            options += option_row(option);
    }
    for (const ReferenceCommand& sub : command.commands)
        commands += row(link(sub), markdown_sentence(sub.help));
    const std::string footer =
        above != nullptr && above->footer == command.footer ? "" : command.footer;
    std::string text = "\n## " + command.name + "\n\n" + markdown_sentence(command.help) + "\n\n" +
                       code(synopsis(command, unchanged, unchanged)) + "\n" +
                       paragraphs(footer, Section::description) + table("argument", arguments) +
                       table("option", options) + table("command", commands) +
                       paragraphs(footer, Section::statuses);
    for (const ReferenceCommand& sub : command.commands) text += command_sections(sub, &command);
    return text;
}

}  // namespace

std::string markdown_page(const ReferenceCommand& program) {
    return "# Commands and options\n\n"
           "Every command with its options, as `scb COMMAND --help` prints them. "
           "Help has examples, too. This page is the\n"
           "output of `scb reference`, and a test compares it.\n\n"
           "The options of [`scb`](#scb) hold for each command.\n" +
           command_sections(program, nullptr);
}

}  // namespace scb::app
