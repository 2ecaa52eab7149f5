#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace scb::scenes {

/// The bytes of a file from its start, at most `most` of them. Throws InputError, naming the file,
/// where it is missing, a directory, or cannot be read.
std::string file_bytes(const std::string& path,
                       std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace scb::scenes
