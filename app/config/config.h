#pragma once

#include <string>
#include <vector>

#include "app/config/command_line.h"
#include "app/config/config_file.h"

namespace scb::app {

/// A command line with what configuration files add to it.
struct ConfiguredLine {
    std::vector<std::string> words;
    std::vector<Setting> settings;  ///< the added settings

    /// The sentence of an error, with the place of the setting that caused it, if any.
    std::string placed(const std::string& sentence) const;
    /// Names the settings from the working folder, whose files may be a stranger's; or empty.
    std::string note() const;
};

/// Adds the settings in the files to the command line, except options that the command line or the
/// environment sets. Adds nothing with --no-config, nor to commands about the program itself.
/// `table` records the added options. Throws InputError, see read_config_files.
ConfiguredLine configured(const CommandLine& line, const ReferenceCommand& program,
                          OptionTable& table);

}  // namespace scb::app
