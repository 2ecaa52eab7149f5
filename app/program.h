#pragma once

#include <string>
#include <vector>

#include "app/cli/watch.h"

namespace scb::app {

inline constexpr const char* out_of_memory =
    "out of memory; use a smaller mesh or picture, fewer levels, or --max-pairs.";

/// Runs the program `scb` with these words behind its name, and returns its exit status. Results go
/// to standard output; messages go to standard error. Sets `watch.wanted` for --watch.
int run_program(const std::vector<std::string>& words, Watch& watch);

}  // namespace scb::app
