#pragma once

#include <functional>

namespace scb::scenes {

/// Runs an action in a child process that ends with it, and tells whether the child came to the
/// end: false where it crashed or used more than five minutes of processor time. What the action
/// throws is swallowed, and nothing that it does is seen by the caller. True where no child can be
/// started.
///
/// For the readers of a library that is not hardened: a broken file must not take the program with
/// it.
bool survives(const std::function<void()>& action);

}  // namespace scb::scenes
