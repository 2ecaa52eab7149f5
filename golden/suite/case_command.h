#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden/suite/suite.h"

namespace scb::golden {

/// The command line of a case after `scb`: writes into `folder`, or prints JSON if it makes no
/// picture.
std::vector<std::string> command_of(const GoldenCase& golden, const std::filesystem::path& folder);

/// The words of GoldenCase::command for this file.
std::vector<std::string> maker_of(const GoldenCase& golden, const std::filesystem::path& file);

/// The command line that records the trace of this frame of the case's query.
std::vector<std::string> trace_command_of(const GoldenCase& golden, const std::string& frame,
                                          const std::filesystem::path& file);

/// The case with its command line for the folder of the suite, which may be anywhere.
GoldenCase in_own_folder(GoldenCase golden);

/// The case with its command line for the current folder: files of the suite are in `folder`, the
/// folder of the suite, or else in the folder of models.
GoldenCase seen_from_here(GoldenCase golden, const std::filesystem::path& folder,
                          const std::filesystem::path& models);

/// The text as one word of a POSIX shell: in single quotes if it needs them.
std::string shell_word(const std::string& text);

}  // namespace scb::golden
