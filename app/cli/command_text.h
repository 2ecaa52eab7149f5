#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"

namespace scb::app {

/// Those of the named options (and positional ones) that were given, on the command line or by the
/// environment, as they would be given again: " --test extents --frames 0,250"; empty, or with a
/// space in front.
std::string given_text(const Command& command, const std::vector<std::string>& options);

/// The command with all that was given but the options `left_out`, in the order of its help: "scb
/// render pairs spheres-l1 --frames 100". Of a path there is the name of the file only, so that the
/// text says nothing of the machine.
std::string told_command(const Command& command, const std::vector<std::string>& left_out);

/// The same as words that the program takes again, behind its name; of paths the whole.
std::vector<std::string> given_words(const Command& command,
                                     const std::vector<std::string>& left_out);

/// The name of a file as a word of the shell that is not taken for an option.
std::string file_word(const std::string& name);

}  // namespace scb::app
