#pragma once

#include <filesystem>
#include <string>

namespace scb::scenes {

/// Notes that this process reads a file for its user, which nothing that it writes may replace.
/// Whatever reads scenes, meshes, traces, cameras, pairs and suites notes them; the files that this
/// program keeps for itself, such as baselines, are not noted. Any thread may call this. No effect
/// where there is no such file.
void note_input(const std::filesystem::path& file);

/// Throws InputError where the path leads to a file that was noted, by whatever name. `option` is
/// the one that says where to write. To be called when all has been read, and before anything is
/// written or removed.
void refuse_input(const std::filesystem::path& output, const std::string& option);

}  // namespace scb::scenes
