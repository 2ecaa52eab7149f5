#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "app/program.h"
#include "core/base/exit_status.h"
#include "golden/run/command_worker.h"
#include "scenes/meshes/isolated_mesh.h"
#include "scenes/meshes/mesh_answer.h"
#include "scenes/meshes/mesh_reader.h"
#include "scenes/scene/kept_hierarchies.h"

namespace scb::app {
namespace {

// Memory may run out where exceptions cannot pass: destructors of JSON documents allocate.
[[noreturn]] void end_at_once() {
    try {
        if (const std::exception_ptr error = std::current_exception())
            std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        tell_out_of_memory();
        ::_exit(exit_environment);
    } catch (...) {
    }
    std::abort();
}

// If the program was started without standard output, a file that it opens must not take its place.
// The replacement can be neither read nor written, so that printing fails.
void hold_standard_descriptors() {
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(standard, F_GETFD) < 0) ::open("/", O_PATH);
}

int run_command(const std::vector<std::string>& words) {
    Watch watch;
    const int status = run_program(words, watch);
    if (!watch.wanted) return status;
    std::string name = "scb";
    std::vector<char*> arguments = {name.data()};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    run_again_after_change(watch, arguments.data());
    return status;
}

}  // namespace
}  // namespace scb::app

int main(int argc, char** argv) {
    std::set_terminate(scb::app::end_at_once);
    scb::app::hold_standard_descriptors();
    // Exceeding a file size limit is reported as a write error. A closed pipe ends the program
    // silently, as usual.
    std::signal(SIGXFSZ, SIG_IGN);
    // The parent process may ignore SIGCHLD; then the exit status of children would be lost.
    std::signal(SIGCHLD, SIG_DFL);
    if (argc == 3 && std::strcmp(argv[1], scb::scenes::mesh_reader_command) == 0)
        // No cleanup is left, and the confined process may not make the calls of the leak
        // sanitizer.
        ::_exit(scb::scenes::run_mesh_reader(argv[2]));
    scb::scenes::set_mesh_reader("/proc/self/exe");
    if (argc == 2 && std::strcmp(argv[1], scb::golden::worker_command) == 0) {
        // A suite has many cases of the same scene.
        scb::scenes::keep_hierarchies();
        return scb::golden::run_commands(scb::app::run_command);
    }
    return scb::app::run_command({argv + std::min(argc, 1), argv + argc});
}
