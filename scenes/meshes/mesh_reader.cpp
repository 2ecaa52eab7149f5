#include "scenes/meshes/mesh_reader.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <new>
#include <span>
#include <system_error>
#include <utility>

#include "scb/error.h"
#include "scenes/meshes/assimp_mesh.h"

namespace scb::scenes {
namespace {

namespace fs = std::filesystem;

// The reader's descriptor that its answer goes to.
constexpr int answer_descriptor = 3;
constexpr unsigned patience = 300;  // seconds

/// How an answer begins. What follows is the vertices and the triangles of a mesh, or a sentence.
struct Answer {
    enum Kind : std::uint32_t { mesh, refusal, out_of_memory, failure };
    std::array<char, 12> magic = {'s', 'c', 'b', '-', 'm', 'e', 's', 'h', '-', '1', 0, 0};
    std::uint32_t kind = failure;
    std::uint64_t first = 0;   ///< vertices, or characters
    std::uint64_t second = 0;  ///< triangles
};
static_assert(sizeof(Answer) == 32 && sizeof(Vec3) == 24 && sizeof(Triangle) == 12);

// More than assimp_mesh gives.
constexpr std::uint64_t most = std::uint64_t{1} << 29;

bool write_all(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(answer_descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

bool read_all(int descriptor, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t got = ::read(descriptor, bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

template <class T>
std::span<const std::byte> bytes_of(const T& values) {
    return std::as_bytes(std::span(values));
}

int answer(Answer::Kind kind, const std::string& sentence) {
    Answer head;
    head.kind = kind;
    head.first = sentence.size();
    return write_all(bytes_of(std::span(&head, 1))) && write_all(bytes_of(sentence)) ? 0 : 1;
}

/// Nothing of what it does may outlast or disturb who started it. False where that cannot be
/// arranged.
bool confine_this_process() {
    const rlimit no_core{0, 0}, processor_seconds{patience, patience};
    ::alarm(patience);
    return ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && ::setrlimit(RLIMIT_CORE, &no_core) == 0 &&
           ::setrlimit(RLIMIT_CPU, &processor_seconds) == 0;
}

fs::path& program() {
    static fs::path path;
    return path;
}

fs::path reader_program() {
    if (!program().empty()) return program();
    return fs::read_symlink("/proc/self/exe").parent_path() / "scb";
}

/// A reader that runs, and the end of the pipe that its answer comes from.
class Reader {
  public:
    explicit Reader(const std::string& path) {
        const std::string file = reader_program().string();
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(file, errno);
        answers_ = ends[0];
        const int error = spawn(file, path, ends[1]);
        ::close(ends[1]);
        if (error == 0) return;
        ::close(answers_);
        fail(file, error);
    }
    ~Reader() {
        ::close(answers_);
        if (id_ > 0) ::kill(id_, SIGKILL);
        wait();
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    bool read(std::span<std::byte> bytes) const { return read_all(answers_, bytes); }

    /// Whether it ended, after its whole answer, as it should.
    bool ended_well() {
        std::byte more{};
        return !read({&more, 1}) && wait();
    }

  private:
    [[noreturn]] static void fail(const std::string& file, int error) {
        throw fs::filesystem_error("cannot start the program that reads meshes; install all of scb",
                                   file, std::error_code(error, std::generic_category()));
    }

    int spawn(std::string file, std::string path, int pipe) {
        posix_spawn_file_actions_t files;
        posix_spawnattr_t attributes;
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&attributes);
        // From above those that it gets, lest one takes the place of another.
        const int copy = ::fcntl(pipe, F_DUPFD_CLOEXEC, answer_descriptor + 1);
        posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&files, copy, answer_descriptor);
        posix_spawn_file_actions_addclosefrom_np(&files, answer_descriptor + 1);
        // A group of its own: Ctrl-C is for who started it. No signal is blocked or handled.
        sigset_t none, all;
        sigemptyset(&none);
        sigfillset(&all);
        posix_spawnattr_setsigmask(&attributes, &none);
        posix_spawnattr_setsigdefault(&attributes, &all);
        posix_spawnattr_setpgroup(&attributes, 0);
        posix_spawnattr_setflags(
            &attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
        std::string command = mesh_reader_command;
        const std::array<char*, 4> arguments = {file.data(), command.data(), path.data(), nullptr};
        const int error = copy < 0 ? errno
                                   : ::posix_spawn(&id_, file.c_str(), &files, &attributes,
                                                   arguments.data(), environ);
        if (copy >= 0) ::close(copy);
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&files);
        if (error != 0) id_ = -1;
        return error;
    }

    bool wait() {
        if (id_ <= 0) return false;
        int status = 0;
        pid_t waited = -1;
        while ((waited = ::waitpid(id_, &status, 0)) < 0 && errno == EINTR) {
        }
        id_ = -1;
        // Where SIGCHLD is ignored nobody learns how it ended, and the answer was whole.
        return waited < 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }

    pid_t id_ = -1;
    int answers_ = -1;
};

template <class T>
bool read_into(const Reader& reader, std::vector<T>& values, std::uint64_t count) {
    values.resize(count);
    return reader.read(std::as_writable_bytes(std::span(values)));
}

}  // namespace

void set_mesh_reader(const fs::path& path) { program() = path; }

int run_mesh_reader(const std::string& path) {
    if (!confine_this_process()) return answer(Answer::failure, "it cannot be read safely here");
    try {
        const Mesh mesh = assimp_mesh(path);
        Answer head;
        head.kind = Answer::mesh;
        head.first = mesh.vertices.size();
        head.second = mesh.triangles.size();
        return write_all(bytes_of(std::span(&head, 1))) && write_all(bytes_of(mesh.vertices)) &&
                       write_all(bytes_of(mesh.triangles))
                   ? 0
                   : 1;
    } catch (const InputError& error) {
        return answer(Answer::refusal, error.what());
    } catch (const std::bad_alloc&) {
        return answer(Answer::out_of_memory, "");
    } catch (const std::exception& error) {
        return answer(Answer::failure, error.what());
    }
}

Mesh isolated_mesh(const std::string& path) {
    Reader reader(path);
    Answer head;
    Mesh mesh;
    std::string sentence;
    const auto whole = [&] {
        if (!reader.read(std::as_writable_bytes(std::span(&head, 1))) ||
            head.magic != Answer{}.magic || head.first > most || head.second > most)
            return false;
        if (head.kind == Answer::mesh)
            return read_into(reader, mesh.vertices, head.first) &&
                   read_into(reader, mesh.triangles, head.second);
        sentence.resize(head.first);
        return reader.read(std::as_writable_bytes(std::span(sentence)));
    };
    if (!whole() || !reader.ended_well())
        throw InputError(path +
                         ": its reader crashed or did not come to an end, so the file is broken; "
                         "repair it or export it again.");
    if (head.kind == Answer::refusal) throw InputError(sentence);
    if (head.kind == Answer::out_of_memory) throw std::bad_alloc();
    if (head.kind == Answer::failure) throw std::runtime_error(sentence);
    return mesh;
}

}  // namespace scb::scenes
