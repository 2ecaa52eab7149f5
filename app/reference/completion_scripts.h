#pragma once

#include <string>

#include "app/reference/command_reference.h"

namespace scb::app {

// What completes a command line of the program in a shell: commands, options, and their values. In
// a list with commas it is the word behind the last one.

/// For bash, with or without the package bash-completion.
std::string bash_completion(const ReferenceCommand& program);
/// For zsh: a function for a folder of $fpath, which can be read with `source` as well.
std::string zsh_completion(const ReferenceCommand& program);
/// For fish.
std::string fish_completion(const ReferenceCommand& program);

}  // namespace scb::app
