#include "app/reference/man_page.h"

#include <algorithm>
#include <sstream>

#include "app/reference/words.h"

namespace scb::app {
namespace {

/// Text that roff prints as it is.
std::string roff(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if (c == '^' || c == '~')
            result += std::string("\\(") + (c == '^' ? "ha" : "ti");
        else if (c == '\'' || c == '`')
            result += std::string("\\(") + (c == '\'' ? "aq" : "ga");
        else if (c == '"')
            result += "\\(dq";
        else if (c == ',')  // where a long list can be broken
            result += ",\\:";
        else
            result += c;
    }
    // A line that begins with a period would be a request.
    return (result.starts_with('.') ? "\\&" : "") + result;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string sentence(const std::string& text) {
    return roff(text) + (text.empty() || text.ends_with('.') ? "" : ".");
}

/// "-o DIR, --output DIR", set in the usual faces.
std::string option_heading(const ReferenceOption& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.names) names.push_back(bold(name));
    std::string text = joined(names, ", ");
    if (option.names.empty()) return italic(option.value);
    return option.takes_value && !option.value.empty() ? text + " " + italic(option.value) : text;
}

std::string option_paragraph(const ReferenceOption& option) {
    std::string text = ".TP\n" + option_heading(option) + "\n" + sentence(option.help);
    if (option.is_required && !option.names.empty()) text += " Must be given.";
    if (!option.default_text.empty()) text += "\nDefault: " + roff(option.default_text) + ".";
    if (!option.environment.empty())
        text += "\nThe environment variable " + bold(option.environment) + " does the same.";
    return text + "\n";
}

/// The text below the options of a help, in sections: examples are one of their own. Lines that are
/// indented stand as they are.
struct Footer {
    std::string description, examples, statuses;

    explicit Footer(const std::string& text) {
        std::istringstream lines(text);
        std::string* section = &description;
        bool is_literal = false;
        const auto set_literal = [&](bool literal) {
            if (literal != is_literal)
                *section += !literal ? ".fi\n" : section->empty() ? ".nf\n" : ".PP\n.nf\n";
            is_literal = literal;
        };
        bool begins = true;
        for (std::string line; std::getline(lines, line);) {
            if (line.empty()) {
                begins = true;
                continue;
            }
            const bool indented = line.starts_with("  ");
            if (!indented) set_literal(false);
            if (begins && !indented) {
                const bool is_examples = line.starts_with("Example");
                constexpr std::string_view status = "Exit status: ";
                section = is_examples                ? &examples
                          : line.starts_with(status) ? &statuses
                                                     : &description;
                begins = false;
                if (is_examples) continue;
                if (section == &statuses) line.erase(0, status.size());
                if (!section->empty()) *section += ".PP\n";
            }
            begins = false;
            if (indented) set_literal(true);
            *section += (indented ? bold(line.substr(2)) : roff(line)) + "\n";
        }
        set_literal(false);
    }
};

std::string synopsis(const ReferenceCommand& command) {
    std::string text = bold(command.name) + (command.options.empty() ? "" : " [\\fIOPTION\\fR...]");
    if (!command.commands.empty()) text += " \\fICOMMAND\\fR ...";
    for (const ReferenceOption& option : command.options)
        if (option.is_required) text += " " + option_heading(option);
    for (const ReferenceOption& argument : command.arguments) {
        const std::string shown = italic(argument.value);
        text += argument.is_required ? " " + shown : " [" + shown + "]";
        if (argument.takes_several)
            text += command.most_arguments == 2 ? " [" + shown + "]" : "...";
    }
    return text;
}

std::string section(const std::string& title, const std::string& text) {
    return text.empty() ? "" : ".SH " + title + "\n" + text;
}

}  // namespace

std::string man_page_name(const ReferenceCommand& command) {
    std::string name = command.name;
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

std::string man_page(const ReferenceCommand& command, const ReferenceCommand& program,
                     const std::string& version) {
    const bool is_program = command.name == program.name;
    const Footer footer(command.footer);
    std::string title = man_page_name(command), arguments, options, commands, others;
    std::transform(title.begin(), title.end(), title.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    for (const ReferenceOption& argument : command.arguments)
        arguments += option_paragraph(argument);
    for (const ReferenceOption& option : command.options) options += option_paragraph(option);
    for (const ReferenceCommand& sub : command.commands)
        commands += ".TP\n" + bold(sub.word()) + "\n" + sentence(sub.help) + "\nSee " +
                    bold(man_page_name(sub)) + "(1).\n";
    if (!is_program) {
        others = ".BR scb (1)";
        options += ".PP\nThe options of " + bold("scb") + " hold here too.\n";
    }
    for (const ReferenceCommand& sub : command.commands)
        others += (others.empty() ? ".BR " : ",\n.BR ") + roff(man_page_name(sub)) + " (1)";
    std::string help = command.help;
    if (help.starts_with("scb: ")) help.erase(0, 5);  // the program's
    const std::string statuses =
        footer.statuses.empty() ? Footer(program.footer).statuses : footer.statuses;
    return ".TH " + roff(title) + " 1 \"\" \"scb " + version + "\"\n.ad l\n" +
           section("NAME", roff(man_page_name(command)) + " \\- " +
                               roff(help.substr(0, help.find_last_not_of('.') + 1)) + "\n") +
           section("SYNOPSIS", synopsis(command) + "\n") +
           section("DESCRIPTION", sentence(help) + "\n" +
                                      (footer.description.empty() ? "" : ".PP\n") +
                                      footer.description) +
           section("COMMANDS", commands) + section("ARGUMENTS", arguments) +
           section("OPTIONS", options) + section("EXIT STATUS", statuses) +
           section("EXAMPLES", footer.examples) + section("SEE ALSO", others + "\n");
}

}  // namespace scb::app
