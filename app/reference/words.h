#pragma once

#include <string>
#include <vector>

#include "app/reference/command_reference.h"

namespace scb::app {

std::string joined(const std::vector<std::string>& parts, const std::string& separator);

/// The text with a backslash before each of these characters.
std::string escaped(const std::string& text, const std::string& characters);

/// The options of the command, then those of the program, which can be given behind it too.
std::vector<const ReferenceOption*> options_of(const ReferenceCommand& command,
                                               const ReferenceCommand& program);

/// How many words can stand where `argument` of the command does.
int most_arguments(const ReferenceCommand& command);

}  // namespace scb::app
