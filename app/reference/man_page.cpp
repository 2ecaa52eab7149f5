#include "app/reference/man_page.h"

#include <algorithm>

#include "app/reference/help_footer.h"
#include "app/reference/synopsis.h"
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

std::string option_paragraph(const ReferenceOption& option) {
    std::string text =
        ".TP\n" + option_heading(option, bold, italic) + "\n" + sentence(option.help);
    if (option.is_required && !option.names.empty()) text += " Must be given.";
    if (!option.default_text.empty()) text += "\nDefault: " + roff(option.default_text) + ".";
    if (!option.environment.empty())
        text += "\nThe environment variable " + bold(option.environment) + " does the same.";
    return text + "\n";
}

/// A section of the text below the options of a help. Indented lines stand as they are.
std::string footer_text(const std::string& footer, FooterPart::Section section) {
    std::string text;
    for (const FooterPart& part : footer_parts(footer, section)) {
        if (!text.empty()) text += ".PP\n";
        if (part.is_literal) text += ".nf\n";
        for (const std::string& line : part.lines)
            text += (part.is_literal ? bold(line) : roff(line)) + "\n";
        if (part.is_literal) text += ".fi\n";
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
    using Section = FooterPart::Section;
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
    const std::string description = footer_text(command.footer, Section::description);
    std::string statuses = footer_text(command.footer, Section::statuses);
    if (statuses.empty()) statuses = footer_text(program.footer, Section::statuses);
    return ".TH " + roff(title) + " 1 \"\" \"scb " + version + "\"\n.ad l\n" +
           section("NAME", roff(man_page_name(command)) + " \\- " +
                               roff(help.substr(0, help.find_last_not_of('.') + 1)) + "\n") +
           section("SYNOPSIS", synopsis(command, bold, italic) + "\n") +
           section("DESCRIPTION",
                   sentence(help) + "\n" + (description.empty() ? "" : ".PP\n") + description) +
           section("COMMANDS", commands) + section("ARGUMENTS", arguments) +
           section("OPTIONS", options) + section("EXIT STATUS", statuses) +
           section("EXAMPLES", footer_text(command.footer, Section::examples)) +
           section("SEE ALSO", others + "\n");
}

}  // namespace scb::app
