#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>

namespace scb {

/// A file could not be written: the disk is full, the folder is missing or may not be written.
/// `what()` is one sentence that names the file, the system's reason and what to do. The program
/// then exits with status 3.
struct OutputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Writes the file whole or not at all: to a new file in the same folder, with a unique name that
/// starts with the name of `path`, which is then renamed to `path`, or to the target of its link.
/// Several threads and programs may write the same path; the last one wins. The file has the
/// permissions of the file that it replaces, or the usual ones of new files. Throws OutputError,
/// and then leaves neither a temporary file nor a changed `path`. If the file system can, the new
/// file has no name before it is whole, so that a signal leaves no file either.
void write_file_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file_whole(const std::filesystem::path& path, std::string_view text);

/// Whether it is an existing file; false for folders.
bool is_there(const std::filesystem::path& path);

}  // namespace scb
