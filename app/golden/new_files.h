#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scb::app {

/// A file to write where none exists yet.
struct NewFile {
    std::filesystem::path path;
    std::string text;
};

/// Throws InputError for the first file whose path, or a folder above it, is taken: nothing is
/// replaced.
void refuse_taken(const std::vector<NewFile>& files);

/// Writes all files, with their folders. If one cannot be written, removes everything that was made
/// and throws OutputError.
void write_new_files(const std::vector<NewFile>& files);

}  // namespace scb::app
