#pragma once

#include <string>

namespace scb::app {

/// Throws InputError where `path` is standard output or a file that was read (see note_input), and
/// OutputError where there cannot be such a file. `folder_to_make` is one that will be there by
/// then. To be called before what takes time, and again when all has been read.
void check_output(const std::string& path, const std::string& option,
                  const std::string& folder_to_make = "");

}  // namespace scb::app
