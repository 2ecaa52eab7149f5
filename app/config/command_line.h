#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/reference/command_reference.h"

namespace scb::app {

/// The words after the program's name, as far as they must be known before parsing.
struct CommandLine {
    std::vector<std::string> words;
    const ReferenceCommand* command = nullptr;  ///< the named command
    std::size_t options_begin = 0;  ///< index of the first word after the command's name
    std::set<const CLI::Option*> given;
    std::vector<std::string> arguments;  ///< words that are neither a command nor an option

    bool has(
        const std::string& option) const;  ///< whether the option was given, by its longest name
};

CommandLine read_command_line(const std::vector<std::string>& words,
                              const ReferenceCommand& program);

}  // namespace scb::app
