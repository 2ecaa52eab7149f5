#pragma once

#include <filesystem>

namespace scb {

/// Whether both are files with the same bytes.
bool files_equal(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace scb
