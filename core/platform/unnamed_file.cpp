#include "core/platform/unnamed_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "core/platform/output_file.h"

namespace scb {
namespace {

[[noreturn]] void fail(const char* verb, int error) {
    throw OutputError(std::string("Cannot ") + verb + " a temporary file: " + std::strerror(error) +
                      "; make room in the system's folder for them (/tmp).");
}

}  // namespace

UnnamedFile::UnnamedFile() : file_(std::tmpfile(), std::fclose) {
    if (!file_) fail("make", errno);
    ::fcntl(descriptor(), F_SETFD, FD_CLOEXEC);
}

std::vector<std::uint8_t> UnnamedFile::bytes() const {
    struct stat status;
    if (::fstat(descriptor(), &status) != 0) fail("read", errno);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(status.st_size));
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t read =
            ::pread(descriptor(), bytes.data() + at, bytes.size() - at, static_cast<off_t>(at));
        if (read < 0 && errno == EINTR) continue;
        if (read <= 0) fail("read", read < 0 ? errno : EIO);
        at += static_cast<std::size_t>(read);
    }
    return bytes;
}

void UnnamedFile::clear() const {
    if (::ftruncate(descriptor(), 0) != 0 || ::lseek(descriptor(), 0, SEEK_SET) != 0)
        fail("empty", errno);
}

}  // namespace scb
