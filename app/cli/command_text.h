#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"

namespace scb::app {

/// The named options (and positional ones) that were given on the command line or by the
/// environment, as words of a command line: " --test extents --frames 0,250". Empty, or begins with
/// a space.
std::string given_text(const Command& command, const std::vector<std::string>& options);

/// The command with all given options except `left_out`, in the order of its help: "scb render
/// pairs spheres-l1 --frames 100". Paths are reduced to the names of files, so that the text
/// reveals nothing about the machine.
std::string shown_command(const Command& command, const std::vector<std::string>& left_out);

/// The same as separate words after the program's name, with whole paths.
std::vector<std::string> given_words(const Command& command,
                                     const std::vector<std::string>& left_out);

/// A file name as a word of the shell that is not mistaken for an option.
std::string file_word(const std::string& name);

}  // namespace scb::app
