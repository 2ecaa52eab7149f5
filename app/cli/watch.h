#pragma once

namespace scb::app {

/// Options of `--watch`.
struct Watch {
    bool wanted = false;
    bool quiet = false;
};

/// Waits until an input file of this process changes, and then replaces this process by the program
/// with the same words. Returns if no file was read.
void run_again_after_change(const Watch& watch, char** words);

}  // namespace scb::app
