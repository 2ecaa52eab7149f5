#include "app/cli/command_text.h"

#include <CLI/CLI.hpp>

#include "golden/suite/shell_word.h"

namespace scb::app {

std::string given_text(const Command& command, const std::vector<std::string>& options) {
    std::string text;
    for (const std::string& name : options) {
        const CLI::Option* option = command.app().get_option(name);
        if (option->count() == 0) continue;
        const bool positional = option->get_positional();
        if (!positional) text += " " + name;
        if (option->get_items_expected_max() == 0) continue;  // a flag
        std::string values;
        for (const std::string& value : option->results()) {
            const char* separator = values.empty() ? "" : positional ? " " : ",";
            // A name that begins like an option.
            const bool dashed = positional && value.starts_with('-');
            values += separator + golden::shell_word(dashed ? "./" + value : value);
        }
        text += " " + values;
    }
    return text;
}

}  // namespace scb::app
