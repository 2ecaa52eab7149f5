#pragma once

#include <string>
#include <vector>

#include "app/config/command_line.h"
#include "app/config/config_file.h"

namespace scb::app {

/// A command line with what configuration files add to it.
struct ConfiguredLine {
    std::vector<std::string> words;
    std::vector<Setting> settings;  ///< those that are added

    /// The sentence of an error, behind the place of the setting that it is about, if any.
    std::string placed(const std::string& sentence) const;
    /// Which settings come from the working folder, whose files may be a stranger's; or nothing.
    std::string note() const;
};

/// Adds to the command line what the files say and neither it nor the environment does. Nothing
/// with --no-config, nor to commands that are about the program itself. `table` is told which
/// options these are. Throws InputError, see read_config_files.
ConfiguredLine configured(const CommandLine& line, const ReferenceCommand& program,
                          OptionTable& table);

}  // namespace scb::app
