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

// Memory may run out where no exception can pass: destructors of JSON documents take some.
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

// A file that is opened must not become the standard output of a program that was started without
// one. What stands in for it can be neither read nor written, so that printing fails.
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
    // A file that may not grow is reported as an error of the write. A closed pipe ends the program
    // silently, as it does others.
    std::signal(SIGXFSZ, SIG_IGN);
    // Whoever started this program may ignore it, and then nobody learns how a child of it ended.
    std::signal(SIGCHLD, SIG_DFL);
    if (argc == 3 && std::strcmp(argv[1], scb::scenes::mesh_reader_command) == 0)
        // Nothing is left to be done, and for the leak sanitizer it may do too little.
        ::_exit(scb::scenes::run_mesh_reader(argv[2]));
    scb::scenes::set_mesh_reader("/proc/self/exe");
    if (argc == 2 && std::strcmp(argv[1], scb::golden::worker_command) == 0) {
        // A suite has many cases of one scene.
        scb::scenes::keep_hierarchies();
        return scb::golden::run_commands(scb::app::run_command);
    }
    return scb::app::run_command({argv + std::min(argc, 1), argv + argc});
}
