#pragma once

#include <sys/wait.h>

#include <cerrno>

namespace scb {

/// Whether every process that this one started has ended and was waited for.
inline bool no_child_is_left() { return ::waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD; }

}  // namespace scb
