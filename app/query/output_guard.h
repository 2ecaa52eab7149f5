#pragma once

#include <string>

namespace scb::app {

/// Throws InputError if `path` is standard output or an input file (see note_input), and
/// OutputError if the file cannot be created. `folder_to_make`: a folder that will be made before
/// the file is written. Call this before long work, and again after all inputs have been read.
void check_output(const std::string& path, const std::string& option,
                  const std::string& folder_to_make = "");

/// Throws InputError if both --json and --csv were given.
void check_one_format(bool json, bool csv);

}  // namespace scb::app
