#include "core/platform/file_window.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include "core/platform/file_bytes.h"
#include "scb/error.h"

namespace scb {
namespace {

constexpr std::size_t window_size = std::size_t{1} << 20;

}  // namespace

FileWindow::FileWindow(const std::string& path)
    : name_(path), window_(std::make_unique_for_overwrite<char[]>(window_size)) {
    check_is_file(path);
    // Without a buffer: the window is one.
    stream_.rdbuf()->pubsetbuf(nullptr, 0);
    stream_.open(path, std::ios::binary);
    if (!stream_) refuse_to_open(path, errno);
    std::error_code error;
    size_ = std::filesystem::file_size(path, error);
    if (error) size_ = 0;
}

void FileWindow::fill(std::size_t count) {
    std::copy(window_.get() + at_, window_.get() + end_, window_.get());
    end_ -= at_;
    at_ = 0;
    while (end_ < count && stream_) {
        stream_.read(window_.get() + end_, static_cast<std::streamsize>(window_size - end_));
        const auto got = static_cast<std::size_t>(stream_.gcount());
        end_ += got;
        read_ += got;
    }
    size_ = std::max(size_, read_);
    if (stream_.bad())
        throw InputError(name_ + ": cannot be read; check its permissions and the disk.");
}

bool FileWindow::skip_far(std::uint64_t count) {
    if (count <= end_ - at_) {
        at_ += static_cast<std::size_t>(count);
        return true;
    }
    if (count > left()) return false;
    go_to(position() + count);
    return true;
}

void FileWindow::go_to(std::uint64_t position) {
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(position));
    at_ = end_ = 0;
    read_ = position;
}

}  // namespace scb
