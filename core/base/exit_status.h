#pragma once

namespace scb {

/// The program's exit status; scripts rely on it.
enum ExitStatus {
    exit_done = 0,           ///< done, or equal
    exit_different = 1,      ///< a comparison found differences, or a baseline is missing
    exit_bad_input = 2,      ///< bad usage or bad input
    exit_environment = 3,    ///< the environment failed: disk full, cannot write, out of memory
    exit_partly_judged = 4,  ///< nothing wrong was found, but not all could be judged
    exit_no_gl = 77,         ///< no OpenGL context
};

/// 130 for Ctrl-C, 143 for SIGTERM, 129 for SIGHUP: the results that were finished are printed and
/// written.
inline int exit_interrupted(int signal) { return 128 + signal; }

}  // namespace scb
