#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

namespace scb {

/// A file that is read from front to back through a window of 1 MiB, so that memory does not depend
/// on its size.
class FileWindow {
  public:
    /// Throws InputError, naming the file, as check_is_file does, and if it cannot be opened.
    explicit FileWindow(const std::string& path);

    const std::string& name() const { return name_; }

    /// The next bytes in the window: at least `count` of them, which is at most 1 MiB, or all up to
    /// the end of the file. Valid until the next call. Throws InputError if the file cannot be
    /// read.
    std::string_view ahead(std::size_t count) {
        if (count > end_ - at_) fill(count);
        return {window_.get() + at_, end_ - at_};
    }
    /// Skips bytes that ahead() returned.
    void skip(std::size_t count) { at_ += count; }
    /// Skips any number of bytes. False if the file ends before.
    bool skip_far(std::uint64_t count);

    /// The number of bytes left in the file, by its size.
    std::uint64_t left() const { return size_ - position(); }
    std::uint64_t position() const { return read_ - (end_ - at_); }
    void go_to(std::uint64_t position);

  private:
    void fill(std::size_t count);

    std::string name_;
    std::ifstream stream_;
    std::unique_ptr<char[]> window_;
    std::size_t at_ = 0, end_ = 0;  ///< the range of the next bytes in the window
    std::uint64_t read_ = 0, size_ = 0;
};

}  // namespace scb
