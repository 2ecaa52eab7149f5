#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/reference/command_reference.h"

namespace scb::app {

/// A default of an option in a configuration file.
struct Setting {
    std::string file;
    std::string section;  ///< "render levels", "render", or "*": all except `scb golden`
    std::string name;     ///< of the option: "--volume"
    std::string value;    ///< "true" or "false" for a flag

    /// Whether the setting applies to the command.
    bool reaches(const ReferenceCommand& command) const;
};

struct ConfigFile {
    std::filesystem::path path;
    bool is_there = false;
    std::vector<Setting> settings;
};

/// The configuration files, in order of precedence: scb.json in the working folder, then
/// scb/config.json in XDG_CONFIG_HOME or ~/.config. Throws InputError with the file and the key if
/// a file is invalid.
std::vector<ConfigFile> read_config_files(const ReferenceCommand& program);

/// The settings in effect for a command: for each option the first file that has it, and in this
/// file the most specific section.
std::vector<Setting> settings_of(const ReferenceCommand& command,
                                 const std::vector<ConfigFile>& files);

/// The command's option of that name that a file may set; null if there is none.
const ReferenceOption* configurable(const ReferenceCommand& command, const std::string& name);

}  // namespace scb::app
