#pragma once

#include <string>

namespace scb::golden {

/// The text as one word of a POSIX shell: in single quotes if it needs them.
std::string shell_word(const std::string& text);

}  // namespace scb::golden
