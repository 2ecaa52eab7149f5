#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"

namespace scb::app {

/// An option as its users know it.
struct ReferenceOption {
    std::vector<std::string> names;  ///< as they are typed: "-o", "--output"
    std::string value;               ///< what help shows for it: "DIR"; of a flag nothing
    std::string help, default_text, environment;
    bool takes_value = false;
    bool takes_several = false;  ///< values, one after the other
    bool is_required = false;
    bool is_only_typed = false;           ///< no configuration file may give it
    bool is_shareable = false;            ///< see Option::shareable
    const CLI::Option* parsed = nullptr;  ///< which of the parser's it is
    OptionValues values;

    bool has_name(const std::string& name) const;
};

/// A command as its users know it: what its description for the parser says, without the parser.
struct ReferenceCommand {
    std::string name;  ///< "scb render levels"
    std::string help, footer;
    std::vector<ReferenceOption> options;
    std::vector<ReferenceOption> arguments;  ///< without a name, in their order
    int most_arguments = 0;
    std::vector<ReferenceCommand> commands;

    /// The last word of its name.
    std::string word() const;
    /// What stands at every place of an argument; null where nothing does. An option that takes
    /// several values has them there, where there is no argument.
    const ReferenceOption* argument() const;
};

/// The program that the command belongs to, without what help hides.
ReferenceCommand reference_of_program(const Command& command);

/// The command and all below it.
std::vector<const ReferenceCommand*> all_commands(const ReferenceCommand& program);

}  // namespace scb::app
