#include "scenes/meshes/isolated_mesh.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/platform/input_files.h"
#include "scb/error.h"
#include "scenes/meshes/confinement.h"
#include "scenes/meshes/left_out.h"
#include "scenes/meshes/mesh_answer.h"

namespace scb::scenes {
namespace {

namespace fs = std::filesystem;

fs::path& set_program() {
    static fs::path path;
    return path;
}

[[noreturn]] void fail_to_start(const std::string& mesh, const std::string& program,
                                const std::string& reason) {
    throw MeshReaderError(mesh + ": such meshes are read by a process of " + program +
                          ", which did not start (" + reason +
                          "); check that /proc is mounted, and the limits of processes, files and "
                          "memory (ulimit -u, -n, -v).");
}
[[noreturn]] void fail_to_start(const std::string& mesh, const std::string& program, int error) {
    fail_to_start(mesh, program, std::generic_category().message(error));
}

struct Descriptor {
    int number = -1;

    Descriptor() = default;
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    void close() {
        if (number >= 0) ::close(std::exchange(number, -1));
    }
};

/// The settings of a new process, and the first error of the calls.
struct SpawnSettings {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    int error = 0;

    /// `answers`: for mesh_answer_descriptor, from above it.
    explicit SpawnSettings(int answers) {
        keep(posix_spawn_file_actions_init(&files));
        keep(posix_spawnattr_init(&attributes));
        for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
            keep(posix_spawn_file_actions_addopen(&files, standard, "/dev/null", O_RDWR, 0));
        keep(posix_spawn_file_actions_adddup2(&files, answers, mesh_answer_descriptor));
        keep(posix_spawn_file_actions_addclosefrom_np(&files, mesh_answer_descriptor + 1));
        // A session of its own: Ctrl-C and the terminal belong to the starting process. No signal
        // is blocked or ignored.
        sigset_t none, all;
        sigemptyset(&none);
        sigfillset(&all);
        keep(posix_spawnattr_setsigmask(&attributes, &none));
        keep(posix_spawnattr_setsigdefault(&attributes, &all));
        keep(posix_spawnattr_setflags(
            &attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF));
    }
    ~SpawnSettings() {
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&files);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;

    void keep(int result) {
        if (error == 0) error = result;
    }
};

/// A running reader process, and the pipe of its answer.
class Reader {
  public:
    explicit Reader(std::string path) : program_(mesh_reader().string()) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail_to_start(path, program_, errno);
        Descriptor given, copy;
        answers_.number = ends[0];
        given.number = ends[1];
        copy.number = ::fcntl(given.number, F_DUPFD_CLOEXEC, mesh_answer_descriptor + 1);
        if (copy.number < 0) fail_to_start(path, program_, errno);
        const SpawnSettings settings(copy.number);
        std::string command = mesh_reader_command;
        const std::array<char*, 4> arguments = {program_.data(), command.data(), path.data(),
                                                nullptr};
        int error = settings.error;
        if (error == 0)
            error = ::posix_spawn(&id_, program_.c_str(), &settings.files, &settings.attributes,
                                  arguments.data(), environ);
        if (error == 0) return;
        id_ = -1;
        fail_to_start(path, program_, error);
    }
    ~Reader() { end(); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// False at the end of the answer, or if the deadline has passed.
    bool read(std::span<std::byte> bytes) {
        while (!bytes.empty()) {
            pollfd pipe{answers_.number, POLLIN, 0};
            const int ready = ::poll(&pipe, 1, milliseconds_left());
            if (ready < 0 && errno == EINTR) continue;
            if (ready == 0) is_late_ = true;
            if (ready <= 0) return false;
            const ssize_t got = ::read(answers_.number, bytes.data(), bytes.size());
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return false;
            bytes = bytes.subspan(static_cast<std::size_t>(got));
        }
        return true;
    }

    /// Ends the process if it still runs. Returns its status as from waitpid; nothing if SIGCHLD is
    /// ignored, since the system then does not report it.
    std::optional<int> end() {
        answers_.close();
        if (id_ < 0) return std::nullopt;
        if (whole_) give_time_to_end();
        // The system keeps the id of an ended process until it is waited for, except if SIGCHLD is
        // ignored.
        siginfo_t ignored;
        if (::waitid(P_PID, static_cast<id_t>(id_), &ignored, WEXITED | WNOHANG | WNOWAIT) == 0)
            ::kill(id_, SIGKILL);
        int status = 0;
        pid_t waited = -1;
        while ((waited = ::waitpid(id_, &status, 0)) < 0 && errno == EINTR) {
        }
        id_ = -1;
        if (waited < 0) return std::nullopt;
        return status;
    }

    /// Waits for its end if it has closed the pipe; else ends it, as if it had failed.
    std::optional<int> wait() {
        std::byte rest{};
        whole_ = !read(std::span(&rest, 1));
        const std::optional<int> status = end();
        constexpr int failed = 1 << 8;
        return whole_ ? status : failed;
    }

    const std::string& program() const { return program_; }
    /// It was ended because it did not answer.
    bool is_late() const { return is_late_; }

  private:
    int milliseconds_left() const {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            deadline_ - std::chrono::steady_clock::now());
        return static_cast<int>(std::max<std::int64_t>(left.count(), 0));
    }

    /// Waits up to some seconds after it has closed the pipe, since it then ends by itself.
    void give_time_to_end() const {
        for (int i = 0; i < 2000; ++i) {
            siginfo_t ended{};
            if (::waitid(P_PID, static_cast<id_t>(id_), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 ||
                ended.si_pid != 0)
                return;
            std::this_thread::sleep_for(std::chrono::milliseconds(i < 20 ? 0 : 1));
        }
    }

    // It ends itself before, unless its file has taken control of it.
    std::chrono::steady_clock::time_point deadline_ =
        std::chrono::steady_clock::now() + std::chrono::seconds(reader_patience + 30);
    bool is_late_ = false;
    std::string program_;
    Descriptor answers_;
    pid_t id_ = -1;
    bool whole_ = false;  ///< it has closed the pipe, so it ends by itself
};

[[noreturn]] void refuse_after(std::optional<int> status, const std::string& path) {
    const int signal = status && WIFSIGNALED(*status) ? WTERMSIG(*status) : 0;
    if (signal == SIGKILL)
        throw InputError(path +
                         ": its reader was killed, perhaps because memory ran out; give a smaller "
                         "mesh, or repair its counts.");
    if (signal == SIGALRM || signal == SIGXCPU)
        throw InputError(path +
                         ": its reader did not end within its time limit (8 seconds and 2 for each "
                         "MB, or the limit of ulimit -t); repair the file or export it again.");
    if (signal == SIGINT || signal == SIGTERM || signal == SIGHUP)
        throw MeshReaderError(path + ": its reader was ended by a signal (" + ::strsignal(signal) +
                              "); try again.");
    throw InputError(path +
                     ": the reader of this format crashed on the file, which may be valid; convert "
                     "it to PLY or STL with another program.");
}

}  // namespace

void set_mesh_reader(const fs::path& program) { set_program() = program; }

fs::path mesh_reader() {
    if (!set_program().empty()) return set_program();
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (error) fail_to_start("/proc/self/exe", "scb", error.value());
    return program.parent_path() / "scb";
}

Mesh isolated_mesh(const std::string& path) {
    Reader reader(path);
    MeshGreeting greeting{};
    if (!reader.read(std::as_writable_bytes(std::span(greeting)))) {
        const std::optional<int> status = reader.wait();
        const bool killed = status && WIFSIGNALED(*status);
        fail_to_start(path, reader.program(),
                      killed ? ::strsignal(WTERMSIG(*status)) : "it ended without an answer");
    }
    if (greeting != mesh_greeting)
        fail_to_start(path, reader.program(), "the program is not this version of scb");
    std::optional<ReceivedAnswer> answer =
        receive_answer([&](std::span<std::byte> bytes) { return reader.read(bytes); });
    const std::optional<int> status = reader.wait();
    if (reader.is_late()) refuse_after(SIGALRM, path);
    if (!answer || (status && *status != 0)) refuse_after(status, path);
    if (answer->kind == MeshAnswer::refusal) throw InputError(answer->sentence);
    if (answer->kind == MeshAnswer::limited) throw MeshReaderError(answer->sentence);
    if (answer->kind == MeshAnswer::unconfined)
        throw MeshReaderError(path + ": meshes are read by a process of " + reader.program() +
                              " that is confined, which this system does not allow (" +
                              answer->sentence +
                              "); use a PLY or OBJ file, or a system with seccomp.");
    if (answer->kind == MeshAnswer::failure) throw std::runtime_error(answer->sentence);
    for (const std::string& file : answer->side_files) note_input(file);
    note_left_out(path, answer->left_out);
    return std::move(answer->mesh);
}

}  // namespace scb::scenes
