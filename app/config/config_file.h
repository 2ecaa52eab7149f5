#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/reference/command_reference.h"

namespace scb::app {

/// A default of an option, as a configuration file has it.
struct Setting {
    std::string file;
    std::string section;  ///< "render levels", "render", or "*": all but `scb golden`
    std::string name;     ///< of the option: "--volume"
    std::string value;    ///< of a flag "true" or "false"

    /// Whether it is of this command.
    bool reaches(const ReferenceCommand& command) const;
};

struct ConfigFile {
    std::filesystem::path path;
    bool is_there = false;
    std::vector<Setting> settings;
};

/// The files that are looked for, the one that wins first: scb.json in the working folder, then
/// scb/config.json where XDG_CONFIG_HOME says, or in ~/.config. Throws InputError, which names the
/// file and the key, where one is not as it must be.
std::vector<ConfigFile> read_config_files(const ReferenceCommand& program);

/// What holds of the options of a command: of each the first file's, and in a file that of the
/// section that says most of the command's name.
std::vector<Setting> settings_of(const ReferenceCommand& command,
                                 const std::vector<ConfigFile>& files);

/// The command's option of that name that a file may give; null where it has none.
const ReferenceOption* configurable(const ReferenceCommand& command, const std::string& name);

}  // namespace scb::app
