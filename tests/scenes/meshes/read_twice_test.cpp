#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <vector>

#include "scenes/meshes/mesh_file.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

namespace fs = std::filesystem;

template <class T>
void append_bytes(std::string& bytes, const std::vector<T>& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

/// All bits of the vertices and triangles of a file, as a new process reads it; nothing where it is
/// refused. Memory that nothing was written to has bytes that depend on `filling`.
std::optional<std::string> read_in_a_process(const fs::path& file, int filling) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        ::mallopt(M_PERTURB, filling);
        // For the process that this one starts.
        const std::string number = std::to_string(filling);
        ::setenv("MALLOC_PERTURB_", number.c_str(), 1);
        ::setenv("ASAN_OPTIONS",
                 ("max_malloc_fill_size=1000000000:malloc_fill_byte=" + number).c_str(), 1);
        std::string bytes = "refused";
        try {
            const Mesh mesh = load_mesh(file);
            bytes = "mesh";
            append_bytes(bytes, mesh.vertices);
            append_bytes(bytes, mesh.triangles);
        } catch (const std::exception&) {
        }
        for (std::size_t at = 0; at < bytes.size();) {
            const ssize_t written = ::write(ends[1], &bytes[at], bytes.size() - at);
            if (written <= 0) ::_exit(1);
            at += static_cast<std::size_t>(written);
        }
        ::_exit(0);
    }
    ::close(ends[1]);
    std::string bytes;
    char block[65536];
    for (ssize_t got = 0; (got = ::read(ends[0], block, sizeof block)) > 0;)
        bytes.append(block, static_cast<std::size_t>(got));
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0) << file;
    if (bytes == "refused") return std::nullopt;
    return bytes;
}

std::vector<fs::path> files_of_folder(const fs::path& folder) {
    std::vector<fs::path> files;
    if (fs::is_directory(folder))
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// How many of the files are read; each of them twice, with the same bits.
int read_twice(const std::vector<fs::path>& files) {
    int accepted = 0;
    for (const fs::path& file : files) {
        const std::optional<std::string> first = read_in_a_process(file, 0x55);
        if (!first) continue;
        ++accepted;
        EXPECT_EQ(read_in_a_process(file, 0xaa), first) << file;
    }
    return accepted;
}

const fs::path source_folder = SCB_SOURCE_DIR;

TEST(ReadTwice, FilesOfTheCorpusHaveTheSameBits) {
    std::vector<fs::path> files;
    for (const char* kind : {"ply", "obj", "mesh", "assimp"})
        for (const fs::path& file : files_of_folder(source_folder / "tests/fuzz/corpus" / kind))
            files.push_back(file);
    EXPECT_GT(read_twice(files), 20);
}

TEST(ReadTwice, HostileFilesHaveTheSameBits) {
    const fs::path hostile = source_folder / "../shared/hostile";
    if (!fs::is_directory(hostile)) GTEST_SKIP() << "../shared/hostile is not there";
#ifdef SCB_SANITIZED
    GTEST_SKIP() << "sanitized, a reader has no limit of memory";
#endif
    std::vector<fs::path> files;
    for (const char* kind : {"ply", "mesh", "readers"})
        for (const fs::path& file : files_of_folder(hostile / kind)) files.push_back(file);
    EXPECT_GT(read_twice(files), 20);
}

}  // namespace
}  // namespace scb::scenes
