#pragma once

#include <filesystem>

namespace scb::golden {

/// Whether both are files that can be read and have the same bytes. Two pictures in such files need
/// not be decoded to be compared. False where either is missing or unreadable: whoever then reads
/// it says why.
bool files_equal(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace scb::golden
