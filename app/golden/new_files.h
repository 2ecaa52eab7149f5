#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scb::app {

/// A file to be written where none is yet.
struct NewFile {
    std::filesystem::path path;
    std::string text;
};

/// Throws InputError for the first whose place, or that of a folder above it, is taken by whatever:
/// nothing is replaced.
void refuse_taken(const std::vector<NewFile>& files);

/// Writes all of them, with their folders. Throws OutputError where one cannot be written, and then
/// takes away what was made for the others.
void write_new_files(const std::vector<NewFile>& files);

}  // namespace scb::app
