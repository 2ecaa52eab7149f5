#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>

namespace scb::render {

/// A file could not be written: the disk is full, the folder is missing or may not be written.
/// `what()` is one sentence that names the file, the system's reason and what to do. A program that
/// meets it exits with status 3.
struct OutputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Writes the file whole or not at all: to a new file in the same folder, whose name starts with
/// that of `path` and is its own, then renamed over `path`, or over what it links to; several
/// threads and programs may write the same path, and one of them is the last. The file has the
/// permissions of the one that it replaces, or those that any new file gets. Throws OutputError,
/// and leaves neither a temporary file nor a changed `path` behind. Where the file system can, the
/// new file has no name before it is whole, so that a signal leaves none either.
void write_file_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file_whole(const std::filesystem::path& path, std::string_view text);

/// Whether it is a file: a folder of that name is none.
bool is_there(const std::filesystem::path& path);

}  // namespace scb::render
