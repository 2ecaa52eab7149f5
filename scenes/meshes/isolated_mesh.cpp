#include "scenes/meshes/isolated_mesh.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/platform/input_files.h"
#include "core/platform/process.h"
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

/// "signal 9 (Killed)".
std::string signal_words(int signal) {
    return "signal " + std::to_string(signal) + " (" + ::strsignal(signal) + ")";
}

/// A running reader process, and the pipe of its answer.
class Reader {
  public:
    explicit Reader(const std::string& path) : program_(mesh_reader().string()) {
        try {
            start(path);
        } catch (const std::system_error& error) {
            fail_to_start(path, program_, error.code().message());
        }
    }
    ~Reader() { end(); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// False at the end of the answer, or if the deadline has passed.
    bool read(std::span<std::byte> bytes) {
        return read_fully(
            answers_.number(), {reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size()},
            [this] { return is_late_ = std::chrono::steady_clock::now() >= deadline_; });
    }

    /// Ends the process if it still runs. Nothing if SIGCHLD is ignored, since the system then does
    /// not report how the process ended.
    std::optional<ProcessEnd> end() {
        answers_.close();
        if (id_ < 0) return std::nullopt;
        if (whole_) give_time_to_end();
        kill_process(id_);
        return wait_for_process(std::exchange(id_, -1));
    }

    /// Waits for its end if it has closed the pipe; else ends it, as if it had failed.
    std::optional<ProcessEnd> wait() {
        std::byte rest{};
        whole_ = !read(std::span(&rest, 1));
        const std::optional<ProcessEnd> end = this->end();
        return whole_ ? end : ProcessEnd{false, 1};
    }

    const std::string& program() const { return program_; }
    /// It was ended because it did not answer.
    bool is_late() const { return is_late_; }

  private:
    void start(const std::string& path) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail();
        answers_ = Descriptor(ends[0]);
        const Descriptor given(ends[1]), null(::open("/dev/null", O_RDWR | O_CLOEXEC));
        if (null.number() < 0) fail();
        static_assert(mesh_answer_descriptor == 3);
        id_ = start_process({program_, mesh_reader_command, path},
                            {null.number(), null.number(), null.number(), given.number()});
    }

    [[noreturn]] static void fail() { throw std::system_error(errno, std::generic_category()); }

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

[[noreturn]] void refuse_after(const std::optional<ProcessEnd>& end, const std::string& path) {
    const int signal = end && end->by_signal ? end->code : 0;
    if (signal == SIGKILL)
        throw InputError(path +
                         ": its reader was killed, perhaps because memory ran out; give a smaller "
                         "mesh, or repair its counts.");
    if (signal == SIGALRM || signal == SIGXCPU)
        throw InputError(path +
                         ": its reader did not end within its time limit (8 seconds and 2 for each "
                         "MB, or the limit of ulimit -t); repair the file or export it again.");
    if (signal == SIGINT || signal == SIGTERM || signal == SIGHUP)
        throw MeshReaderError(path + ": its reader was ended by " + signal_words(signal) +
                              "; try again.");
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
    if (error) fail_to_start("/proc/self/exe", "scb", error.message());
    return program.parent_path() / "scb";
}

Mesh isolated_mesh(const std::string& path) {
    Reader reader(path);
    MeshGreeting greeting{};
    if (!reader.read(std::as_writable_bytes(std::span(greeting)))) {
        const std::optional<ProcessEnd> end = reader.wait();
        if (end && end->by_signal) {
            const bool asked = end->code == SIGINT || end->code == SIGTERM || end->code == SIGHUP;
            throw MeshReaderError(
                path + ": its reader, a process of " + reader.program() + ", was ended by " +
                signal_words(end->code) + " before it read the file; try again" +
                (asked ? "." : ", and check the limits of memory (ulimit -s, -v)."));
        }
        fail_to_start(path, reader.program(), "it ended without an answer");
    }
    if (greeting != mesh_greeting)
        fail_to_start(path, reader.program(), "the program is not this version of scb");
    std::optional<ReceivedAnswer> answer =
        receive_answer([&](std::span<std::byte> bytes) { return reader.read(bytes); });
    const std::optional<ProcessEnd> end = reader.wait();
    if (reader.is_late()) refuse_after(ProcessEnd{true, SIGALRM}, path);
    if (!answer || (end && *end != ProcessEnd{})) refuse_after(end, path);
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
