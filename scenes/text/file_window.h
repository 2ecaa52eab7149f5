#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

namespace scb::scenes {

/// A file that is read from front to back through a window of 1 MiB, so that its size costs no
/// memory.
class FileWindow {
  public:
    /// Throws InputError, naming the file, where check_is_file does, and where it cannot be opened.
    explicit FileWindow(const std::string& path);

    const std::string& name() const { return name_; }

    /// All that the window holds of what is next: at least `count` bytes, which are at most 1 MiB,
    /// or all up to the end of the file. Valid until the next call. Throws InputError where the
    /// file cannot be read.
    std::string_view ahead(std::size_t count) {
        if (count > end_ - at_) fill(count);
        return {window_.get() + at_, end_ - at_};
    }
    /// Goes on behind bytes that were seen ahead.
    void skip(std::size_t count) { at_ += count; }
    /// Goes on behind any number of bytes. False where the file ends before that.
    bool skip_far(std::uint64_t count);

    /// How many bytes of the file are next, as far as its size says.
    std::uint64_t left() const { return size_ - position(); }
    std::uint64_t position() const { return read_ - (end_ - at_); }
    void go_to(std::uint64_t position);

  private:
    void fill(std::size_t count);

    std::string name_;
    std::ifstream stream_;
    std::unique_ptr<char[]> window_;
    std::size_t at_ = 0, end_ = 0;  ///< what is next, within the window
    std::uint64_t read_ = 0, size_ = 0;
};

}  // namespace scb::scenes
