#include "core/platform/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <utility>

namespace scb {
namespace {

std::string advice(int error) {
    switch (error) {
        case ENOSPC:
        case EDQUOT:
            return "make room on the disk";
        case ENOENT:
            return "create the folder first";
        case EACCES:
        case EPERM:
        case EROFS:
            return "choose a folder that may be written";
        case ENOTDIR:
            return "a part of the path is a file, not a folder";
        case EISDIR:
            return "a folder has that name";
        default:
            return "choose another place";
    }
}

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
    throw OutputError("Cannot write \"" + path.string() + "\": " + std::strerror(error) + "; " +
                      advice(error) + ".");
}

/// Writes everything. Returns 0 or the errno of the error.
int write_all(int file, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

/// Waits until the written bytes are on the disk. This is called before a file gets its name, so
/// that a loss of power leaves the old file or the new one. File systems that cannot do this are
/// accepted.
int synchronized(int file) {
    int result;
    do result = ::fsync(file);
    while (result != 0 && errno == EINTR);
    return result == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

/// Finds an unused name beside `path`. `take` creates the file, or returns -1 and EEXIST if there
/// is such a file. Returns the last result of `take`.
template <class Take>
int take_name_beside(const std::filesystem::path& path, std::string& name, Take take) {
    constexpr int attempts = 100;
    std::random_device random;
    // Leaves room for the suffix if the name has the largest length.
    constexpr std::size_t most = 200;
    const std::string start = (path.parent_path() / path.filename().string().substr(0, most));
    for (int i = 0; i < attempts; ++i) {
        name = start + ".part-" + std::to_string(random());
        const int result = take(name.c_str());
        if (result >= 0 || errno != EEXIST) return result;
    }
    return -1;
}

// Not mkostemp, since only their owner may read its files. To give them the usual mode would take
// the umask, which cannot be read without setting it.
constexpr mode_t mode = 0666;

/// Standard output or standard error if the file is one of them, else -1.
int standard_stream(const struct stat& file) {
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
        struct stat s;
        if (::fstat(stream, &s) == 0 && s.st_dev == file.st_dev && s.st_ino == file.st_ino)
            return stream;
    }
    return -1;
}

}  // namespace

WholeFile::WholeFile(const std::filesystem::path& path) : given_(path) {
    // A link stays, and its target is replaced.
    std::error_code ignored;
    path_ = std::filesystem::canonical(given_, ignored);
    if (path_.empty()) path_ = given_;
    struct stat existing;
    const bool exists = ::stat(path_.c_str(), &existing) == 0;
    if (exists) {
        // /dev/stdout, opened again, would write at the start of the file that it is redirected to.
        const int stream = standard_stream(existing);
        // Neither a device nor a file that this program already writes to is replaced.
        in_place_ = stream >= 0 || (!S_ISREG(existing.st_mode) && !S_ISDIR(existing.st_mode));
        owns_ = stream < 0;
        if (stream >= 0) file_ = stream;
        // Keeps the mode: users that could not read the file before cannot read it now.
        kept_ = existing.st_mode & 0777;
    }
    if (file_ < 0) open();
}

void WholeFile::open() {
    if (in_place_) {
        file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
        return check(file_ < 0 ? errno : 0);
    }
#ifdef O_TMPFILE
    const std::string folder = path_.has_parent_path() ? path_.parent_path().string() : ".";
    file_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, mode);
    if (file_ >= 0) return;
#endif
    open_named();
}

void WholeFile::open_named() {
    file_ = take_name_beside(path_, name_, [](const char* beside) {
        return ::open(beside, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    });
    if (file_ >= 0) return;
    name_.clear();
    check(errno);
}

void WholeFile::settle() {
    if (kept_ && ::fchmod(file_, static_cast<mode_t>(*kept_)) != 0) check(errno);
    check(synchronized(file_));
}

void WholeFile::copy_to_named() {
    const int from = std::exchange(file_, -1);
    int error = 0;
    try {
        open_named();
        std::array<std::uint8_t, 1 << 16> bytes;
        for (off_t at = 0; error == 0;) {
            const ssize_t got = ::pread(from, bytes.data(), bytes.size(), at);
            if (got == 0) break;
            if (got < 0 && errno == EINTR) continue;
            error = got < 0
                        ? errno
                        : write_all(file_, std::span(bytes).first(static_cast<std::size_t>(got)));
            at += got;
        }
    } catch (...) {
        ::close(from);
        throw;
    }
    ::close(from);
    check(error);
    settle();
}

WholeFile::~WholeFile() {
    if (file_ >= 0 && owns_) ::close(file_);
    if (!name_.empty()) ::unlink(name_.c_str());
}

void WholeFile::check(int error) const {
    if (error != 0) fail(given_, error);
}

void WholeFile::append(std::span<const std::uint8_t> bytes) { check(write_all(file_, bytes)); }

void WholeFile::append(std::string_view text) {
    append(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void WholeFile::finish() {
    if (!in_place_) {
        settle();
        if (name_.empty()) {
            const std::string self = "/proc/self/fd/" + std::to_string(file_);
            const int linked = take_name_beside(path_, name_, [&](const char* beside) {
                return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, beside, AT_SYMLINK_FOLLOW);
            });
            if (linked != 0) {
                name_.clear();
                copy_to_named();
            }
        }
    }
    if (owns_) {
        const int closed = ::close(std::exchange(file_, -1));
        check(closed != 0 ? errno : 0);
    }
    if (in_place_) return;
    if (::rename(name_.c_str(), path_.c_str()) != 0) check(errno);
    name_.clear();
}

void write_file_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    WholeFile file(path);
    file.append(bytes);
    file.finish();
}

void write_file_whole(const std::filesystem::path& path, std::string_view text) {
    write_file_whole(path,
                     std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

bool is_there(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

}  // namespace scb
