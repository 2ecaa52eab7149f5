#pragma once

#include <stdexcept>
#include <string>

namespace scb {

/// Bad data from outside: a file, an option, a number that a caller passed in. `what()` is one
/// sentence that says what is wrong, where, and what to do about it. Thrown at load and
/// construction only, never inside a traversal.
class InputError : public std::runtime_error {
  public:
    /// `sentence` becomes what().
    explicit InputError(const std::string& sentence) : std::runtime_error(sentence) {}
};

}  // namespace scb
