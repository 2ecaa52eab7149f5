#pragma once

#include <string>
#include <vector>
#include "app/cli/command.h"

namespace scb::app {

/// Those of the named options (and positional ones) that were given, on the command line or by the
/// environment, as they would be given again: " --test extents --frames 0,250"; empty, or with a
/// space in front.
std::string given_text(const Command& command, const std::vector<std::string>& options);

}  // namespace scb::app
