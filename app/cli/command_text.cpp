#include "app/cli/command_text.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "golden/suite/shell_word.h"

namespace scb::app {
namespace {

/// An option as it would be given again, with a space in front; empty where it was not given.
std::string option_text(const CLI::Option& option, const std::string& name, bool with_folders) {
    if (option.count() == 0) return "";
    const bool positional = option.get_positional();
    const std::string text = positional ? "" : " " + name;
    // A flag; not one that was taken back.
    if (option.get_items_expected_max() == 0) return option.results().back() == "false" ? "" : text;
    std::string values;
    for (const std::string& value : option.results()) {
        const std::string told = with_folders ? value : value.substr(value.rfind('/') + 1);
        const char* separator = values.empty() ? "" : positional ? " " : ",";
        values += separator + (positional ? file_word(told) : golden::shell_word(told));
    }
    return text + " " + values;
}

}  // namespace

std::string file_word(const std::string& name) {
    return golden::shell_word(name.starts_with('-') ? "./" + name : name);
}

std::string given_text(const Command& command, const std::vector<std::string>& options) {
    std::string text;
    for (const std::string& name : options)
        text += option_text(*command.app().get_option(name), name, true);
    return text;
}

std::string told_command(const Command& command, const std::vector<std::string>& left_out) {
    std::string text;
    for (const CLI::App* app = &command.app(); app->get_parent() != nullptr;
         app = app->get_parent())
        text = " " + app->get_name() + text;
    for (const CLI::Option* option : command.app().get_options())
        if (std::none_of(left_out.begin(), left_out.end(),
                         [&](const std::string& name) { return option->check_name(name); }))
            text += option_text(*option, option->get_name(), false);
    return "scb" + text;
}

}  // namespace scb::app
