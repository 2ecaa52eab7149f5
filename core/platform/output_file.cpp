#include "core/platform/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <random>
#include <string>

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

/// Writes into a file without a name, and names it only once it is whole. False if the file system
/// has no such files; else `error` is 0 or the errno of the error.
bool write_unnamed(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                   std::optional<mode_t> kept, std::string& name, int& error) {
#ifdef O_TMPFILE
    const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
    const int file = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
    if (file < 0) return false;
    error = write_all(file, bytes);
    if (error == 0 && kept && ::fchmod(file, *kept) != 0) error = errno;
    if (error == 0) error = synchronized(file);
    const std::string self = "/proc/self/fd/" + std::to_string(file);
    bool named = true;
    if (error == 0)
        named = take_name_beside(path, name, [&](const char* beside) {
                    return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, beside, AT_SYMLINK_FOLLOW);
                }) == 0;
    if (::close(file) != 0 && error == 0) error = errno;
    return named;
#else
    static_cast<void>(path), static_cast<void>(bytes), static_cast<void>(kept),
        static_cast<void>(name), static_cast<void>(error);
    return false;
#endif
}

/// The same into a file that has a name from the start.
int write_named(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                std::optional<mode_t> kept, std::string& name) {
    const int file = take_name_beside(path, name, [](const char* beside) {
        return ::open(beside, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    });
    if (file < 0) {
        name.clear();
        return errno;
    }
    int error = write_all(file, bytes);
    if (error == 0 && kept && ::fchmod(file, *kept) != 0) error = errno;
    if (error == 0) error = synchronized(file);
    if (::close(file) != 0 && error == 0) error = errno;
    return error;
}

/// Standard output or standard error if the file is one of them, else -1.
int standard_stream(const struct stat& file) {
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
        struct stat s;
        if (::fstat(stream, &s) == 0 && s.st_dev == file.st_dev && s.st_ino == file.st_ino)
            return stream;
    }
    return -1;
}

int write_in_place(const std::filesystem::path& path, const struct stat& existing,
                   std::span<const std::uint8_t> bytes) {
    // /dev/stdout, opened again, would write at the start of the file that it is redirected to.
    if (const int stream = standard_stream(existing); stream >= 0) return write_all(stream, bytes);
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) return errno;
    int error = write_all(file, bytes);
    if (::close(file) != 0 && error == 0) error = errno;
    return error;
}

}  // namespace

void write_file_whole(const std::filesystem::path& given, std::span<const std::uint8_t> bytes) {
    // A link stays, and its target is replaced.
    std::error_code ignored;
    std::filesystem::path path = std::filesystem::canonical(given, ignored);
    if (path.empty()) path = given;
    struct stat existing;
    const bool exists = ::stat(path.c_str(), &existing) == 0;
    int error = 0;
    // Neither a device nor a file that this program already writes to is replaced.
    if (exists && ((!S_ISREG(existing.st_mode) && !S_ISDIR(existing.st_mode)) ||
                   standard_stream(existing) >= 0)) {
        error = write_in_place(path, existing, bytes);
    } else {
        // Keeps the mode: users that could not read the file before cannot read it now.
        std::optional<mode_t> kept;
        if (exists) kept = existing.st_mode & 0777;
        std::string name;  // empty if there is no such file
        if (!write_unnamed(path, bytes, kept, name, error)) {
            name.clear();
            error = write_named(path, bytes, kept, name);
        }
        if (error == 0 && ::rename(name.c_str(), path.c_str()) != 0) error = errno;
        if (error != 0 && !name.empty()) ::unlink(name.c_str());
    }
    if (error != 0) fail(given, error);
}

void write_file_whole(const std::filesystem::path& path, std::string_view text) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    write_file_whole(path, std::span(bytes, text.size()));
}

bool is_there(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

}  // namespace scb
