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

std::string option_row(const ReferenceOption& option) {
    std::string text = markdown_sentence(option.help);
    if (option.is_required && !option.names.empty()) text += " Must be given.";
    if (!option.default_text.empty()) text += " Default: " + code(option.default_text) + ".";
    if (!option.environment.empty())
        text += " The environment variable " + code(option.environment) + " does the same.";
    return row(markdown(code(option_heading(option, unchanged, unchanged))), text);
}

/// The paragraphs of a section of the help's footer.
std::string paragraphs(const ReferenceCommand& command, Section section) {
    std::string text;
    for (FooterPart part : footer_parts(command.footer, section)) {
        if (part.is_literal)
            for (std::string& line : part.lines) line = code(line);
        text +=
            "\n" +
            (part.is_literal ? joined(part.lines, "\\\n") : markdown(joined(part.lines, "\n"))) +
            "\n";
    }
    return text;
}

std::string command_section(const ReferenceCommand& command) {
    std::string arguments, options, commands;
    for (const ReferenceOption& argument : command.arguments) arguments += option_row(argument);
    for (const ReferenceOption& option : command.options) options += option_row(option);
    for (const ReferenceCommand& sub : command.commands)
        commands += row(link(sub), markdown_sentence(sub.help));
    const std::string statuses = paragraphs(command, Section::statuses);
    return "\n## " + command.name + "\n\n" + markdown_sentence(command.help) + "\n\n" +
           code(synopsis(command, unchanged, unchanged)) + "\n" +
           paragraphs(command, Section::description) + table("argument", arguments) +
           table("option", options) + table("command", commands) +
           (statuses.empty() ? "" : "\nExit status:\n" + statuses);
}

}  // namespace

std::string markdown_page(const ReferenceCommand& program) {
    std::string text =
        "# Commands and options\n\n"
        "Every command with its options, as `scb COMMAND --help` prints them. Help has examples, "
        "too. This page is the\noutput of `scb reference`, and a test compares it.\n\n"
        "The options of [`scb`](#scb) hold for each command.\n";
    for (const ReferenceCommand* command : all_commands(program)) text += command_section(*command);
    return text;
}

}  // namespace scb::app
