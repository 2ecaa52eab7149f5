#pragma once

#include <filesystem>
#include <utility>
#include <vector>

namespace scb::golden {

/// What the names of folders begin with in which new files wait for their places.
inline constexpr const char* replacement_prefix = ".update-";

/// Puts a copy of the first file of each of `changed` in the place of the second, and removes those
/// that are `gone`; all these places are in `folder`. All or nothing: each file is written beside
/// its place first, none is put there before all are written, and where one cannot be put or
/// removed, those that were have their places and contents again. At every moment a file is the old
/// one or the new one. Throws OutputError, InputError.
void replace_files(
    const std::filesystem::path& folder,
    const std::vector<std::pair<std::filesystem::path, std::filesystem::path>>& changed,
    const std::vector<std::filesystem::path>& gone);

}  // namespace scb::golden
