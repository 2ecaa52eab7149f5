#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace scb {

/// Notes that this process reads a file for its user; the process must not overwrite such files.
/// All readers of scenes, meshes, traces, cameras, pairs and suites note their files. The program's
/// own files, such as baselines, are not noted. Any thread may call this. No effect if there is no
/// such file.
void note_input(const std::filesystem::path& file);

/// The name of the file that was noted last, or an empty name. Allocates nothing, for a process
/// that ends for lack of memory.
const char* last_input() noexcept;

/// Forgets all noted files; for a process that runs the program several times.
void forget_inputs();

/// The regular files that this process noted, each with a text for its contents at the first note.
/// The text changes when the file is written or replaced.
std::map<std::filesystem::path, std::string> input_versions();
/// The same files with the texts for their present contents.
std::map<std::filesystem::path, std::string> present_versions(
    const std::map<std::filesystem::path, std::string>& files);

/// The noted files, as a text for note_inputs in another process.
std::string noted_inputs();
/// Notes the files that another process has noted; other texts have no effect.
void note_inputs(std::string_view noted);

/// Throws InputError if the path leads to a noted file, under any name. `option` is the option for
/// the output. Call this after everything is read, and before anything is written or removed.
void refuse_input(const std::filesystem::path& output, const std::string& option);

}  // namespace scb
