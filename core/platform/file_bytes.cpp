#include "core/platform/file_bytes.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "scb/error.h"

namespace scb {

void refuse_to_open(const std::string& path, int error) {
    // Not std::generic_category: a sanitized program checks the type of that object by a pipe, and
    // there may be no descriptor for one.
    const bool too_many = error == EMFILE || error == ENFILE;
    throw InputError(
        path + ": cannot be opened (" + std::strerror(error) + "); " +
        (too_many ? "raise the limit of open files (ulimit -n)." : "check its permissions."));
}

void check_is_file(const std::string& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
        throw InputError(path + ": there is no such file; check the path.");
    if (!std::filesystem::status_known(status))
        throw InputError(path + ": cannot be reached (" + error.message() +
                         "); check the path and the permissions of its folders.");
    if (std::filesystem::is_directory(status))
        throw InputError(path + ": this is a directory; name a file in it.");
    if (!std::filesystem::is_regular_file(status))
        throw InputError(path + ": this is not a regular file; save it to one first.");
}

std::string lower_case_extension(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

std::string file_bytes(const std::string& path, std::size_t most) {
    check_is_file(path);
    std::ifstream stream(path, std::ios::binary);
    if (!stream) refuse_to_open(path, errno);
    std::string bytes;
    std::error_code ignored;
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    if (!ignored) bytes.reserve(static_cast<std::size_t>(std::min<std::uintmax_t>(size, most)) + 1);
    constexpr std::size_t block = std::size_t{1} << 20;
    while (bytes.size() < most && stream) {
        // Growth doubles the memory, so reserved memory is filled first.
        const std::size_t before = bytes.size(), room = bytes.capacity() - before,
                          wanted = std::min({block, most - before, room > 0 ? room : block});
        bytes.resize(before + wanted);
        stream.read(bytes.data() + before, static_cast<std::streamsize>(wanted));
        bytes.resize(before + static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad())
        throw InputError(path + ": cannot be read; check its permissions and the disk.");
    return bytes;
}

}  // namespace scb
