#include "golden/suite/files_equal.h"

#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>
#include <vector>

namespace scb::golden {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File open_file(const std::filesystem::path& path) {
    return {std::fopen(path.c_str(), "rb"), std::fclose};
}

}  // namespace

bool files_equal(const std::filesystem::path& a, const std::filesystem::path& b) {
    // Sizes are known without reading; folders and missing files have none.
    std::error_code no_size_a, no_size_b;
    const auto size_a = std::filesystem::file_size(a, no_size_a),
               size_b = std::filesystem::file_size(b, no_size_b);
    if (no_size_a || no_size_b || size_a != size_b) return false;
    const File file_a = open_file(a), file_b = open_file(b);
    if (!file_a || !file_b) return false;
    constexpr std::size_t block = std::size_t{1} << 16;  // stacks may be smaller
    std::vector<char> block_a(block), block_b(block);
    for (;;) {
        const std::size_t read_a = std::fread(block_a.data(), 1, block_a.size(), file_a.get()),
                          read_b = std::fread(block_b.data(), 1, block_b.size(), file_b.get());
        if (read_a != read_b || std::memcmp(block_a.data(), block_b.data(), read_a) != 0)
            return false;
        if (read_a < block_a.size())
            return std::ferror(file_a.get()) == 0 && std::ferror(file_b.get()) == 0;
    }
}

}  // namespace scb::golden
