#pragma once

#include <string>
#include <vector>

#include "app/cli/watch.h"

namespace scb::app {

/// Reports on standard error that memory ran out, and the file that was read last. Allocates no
/// memory.
void tell_out_of_memory();

/// Runs the program `scb` with these words behind its name, and returns its exit status. Results go
/// to standard output; messages go to standard error. Sets `watch.wanted` for --watch.
int run_program(const std::vector<std::string>& words, Watch& watch);

}  // namespace scb::app
