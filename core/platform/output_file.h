#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
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

/// A file that is written part by part, with the guarantees of write_file_whole: it has its name
/// once it is whole. A device or a pipe receives the parts at once.
class WholeFile {
  public:
    /// Throws OutputError if it cannot be made.
    explicit WholeFile(const std::filesystem::path& path);
    /// Without finish(), nothing is left of it. A signal may leave a part, where the file system
    /// has no files without a name.
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    void append(std::span<const std::uint8_t> bytes);
    void append(std::string_view text);
    void finish();

  private:
    void open();
    void open_named();
    /// Gives a complete file its mode, and waits until it is on the disk.
    void settle();
    /// Where a file without a name cannot get one.
    void copy_to_named();
    /// Throws OutputError if the errno is not 0.
    void check(int error) const;

    std::filesystem::path given_, path_;  ///< as given; of the target of a link
    int file_ = -1;
    std::string name_;  ///< beside `path_`; empty: without a name, or written in place
    bool in_place_ = false, owns_ = true;
    std::optional<unsigned> kept_;  ///< the mode of the file that is replaced
};

/// Whether it is an existing file; false for folders.
bool is_there(const std::filesystem::path& path);

}  // namespace scb
