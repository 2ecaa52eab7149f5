#pragma once

#include <filesystem>

namespace scb::golden {

/// Whether both are readable files with the same bytes. Pictures in such files need not be decoded
/// for a comparison. False if either is missing or unreadable: the code that then reads it reports
/// why.
bool files_equal(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace scb::golden
