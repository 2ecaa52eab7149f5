#pragma once

#include <filesystem>
#include <utility>
#include <vector>

namespace scb::golden {

/// The prefix of the names of folders with new files that are not in their places yet.
inline constexpr const char* replacement_prefix = ".update-";

/// For each pair of `changed`, puts a copy of the first file in the place of the second, and
/// removes the files `gone`; all these places are in `folder`. All or nothing: each file is first
/// written beside its place, and put there after all are written. If one cannot be put or removed,
/// the others are restored. At every moment a file is the old one or the new one. Throws
/// OutputError, InputError.
void replace_files(
    const std::filesystem::path& folder,
    const std::vector<std::pair<std::filesystem::path, std::filesystem::path>>& changed,
    const std::vector<std::filesystem::path>& gone);

/// Whether both are readable files with the same bytes. Pictures in such files need not be decoded
/// for a comparison. False if either is missing or unreadable: the code that then reads it reports
/// why.
bool files_equal(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace scb::golden
