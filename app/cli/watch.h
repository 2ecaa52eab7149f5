#pragma once

namespace scb::app {

/// What `--watch` asks for.
struct Watch {
    bool wanted = false;
    bool quiet = false;
};

/// Waits until a file that this process has read is another one, and then starts the program
/// again with the same words, in place of this process. Returns where it has read none.
void run_again_after_change(const Watch& watch, char** words);

}  // namespace scb::app
