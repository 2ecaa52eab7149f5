#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace scb {

/// Throws InputError, naming the file, if it is missing, cannot be reached, or is not a regular
/// file.
void check_is_file(const std::string& path);
/// Throws the InputError of a file that could not be opened, for the reason `error` (an errno).
[[noreturn]] void refuse_to_open(const std::string& path, int error);

/// ".ply" for a.PLY: the last dot of a name and the letters behind it, in lower case.
std::string lower_case_extension(const std::string& path);

/// The bytes of a file from its start, at most `most` of them. Throws InputError, naming the file,
/// as check_is_file does, and if it cannot be read.
std::string file_bytes(const std::string& path,
                       std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace scb
