#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace scb::scenes {

/// Notes that this process reads a file for its user, which nothing that it writes may replace.
/// Whatever reads scenes, meshes, traces, cameras, pairs and suites notes them; the files that this
/// program keeps for itself, such as baselines, are not noted. Any thread may call this. No effect
/// where there is no such file.
void note_input(const std::filesystem::path& file);

/// The name of the file that was noted last, or of none; for a process that ends for want of
/// memory, and therefore takes none.
const char* last_input() noexcept;

/// Forgets all files that were noted; for a process that runs the program several times.
void forget_inputs();

/// The regular files that this process noted, each with words for its contents when it was noted
/// first: they are others once somebody has written to it or put another file in its place.
std::map<std::filesystem::path, std::string> input_versions();
/// The same files as they are now.
std::map<std::filesystem::path, std::string> present_versions(
    const std::map<std::filesystem::path, std::string>& files);

/// The files that were noted, as text that another process's note_inputs understands.
std::string noted_inputs();
/// Notes the files that another process has noted; what is no such text has no effect.
void note_inputs(std::string_view noted);

/// Throws InputError where the path leads to a file that was noted, by whatever name. `option` is
/// the one that says where to write. To be called when all has been read, and before anything is
/// written or removed.
void refuse_input(const std::filesystem::path& output, const std::string& option);

}  // namespace scb::scenes
