#include "app/cli/command_text.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "golden/suite/case_command.h"

namespace scb::app {
namespace {

/// The option as words of a command line, after a space; empty if it was not given.
std::string option_text(const CLI::Option& option, const std::string& name, bool with_folders) {
    if (option.count() == 0) return "";
    const bool positional = option.get_positional();
    const std::string text = positional ? "" : " " + name;
    // A flag; empty if it was revoked.
    if (option.get_items_expected_max() == 0) return option.results().back() == "false" ? "" : text;
    std::string values;
    for (const std::string& value : option.results()) {
        const std::string told = with_folders ? value : value.substr(value.rfind('/') + 1);
        const char* separator = values.empty() ? "" : positional ? " " : ",";
        values += separator + (positional ? file_word(told) : golden::shell_word(told));
    }
    return text + " " + values;
}

bool is_one_of(const CLI::Option& option, const std::vector<std::string>& names) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return option.check_name(name); });
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

std::vector<std::string> given_words(const Command& command,
                                     const std::vector<std::string>& left_out) {
    std::vector<std::string> words;
    for (const CLI::App* app = &command.app(); app->get_parent() != nullptr;
         app = app->get_parent())
        words.insert(words.begin(), app->get_name());
    for (const CLI::Option* option : command.app().get_options()) {
        if (option->count() == 0 || is_one_of(*option, left_out)) continue;
        const std::vector<std::string>& values = option->results();
        const std::string& name = option->get_name();
        if (option->get_positional())
            for (const std::string& value : values)
                words.push_back((value.starts_with('-') ? "./" : "") + value);
        else if (option->get_items_expected_max() > 0)
            words.push_back(name + "=" + CLI::detail::join(values, ","));
        else
            words.push_back(name + (values.back() == "true" ? "" : "=" + values.back()));
    }
    return words;
}

std::string shown_command(const Command& command, const std::vector<std::string>& left_out) {
    std::string text;
    for (const CLI::App* app = &command.app(); app->get_parent() != nullptr;
         app = app->get_parent())
        text = " " + app->get_name() + text;
    for (const CLI::Option* option : command.app().get_options())
        if (!is_one_of(*option, left_out)) text += option_text(*option, option->get_name(), false);
    return "scb" + text;
}

}  // namespace scb::app
