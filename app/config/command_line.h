#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/reference/command_reference.h"

namespace scb::app {

/// The words behind the program's name, as far as one must know them before they are parsed.
struct CommandLine {
    std::vector<std::string> words;
    const ReferenceCommand* command = nullptr;  ///< that is named
    std::size_t options_begin = 0;              ///< the place behind the name of the command
    std::set<const CLI::Option*> given;
    std::vector<std::string> arguments;  ///< what is neither a command nor of an option

    bool has(const std::string& option) const;  ///< whether it is given, by its longest name
};

CommandLine read_command_line(const std::vector<std::string>& words,
                              const ReferenceCommand& program);

}  // namespace scb::app
