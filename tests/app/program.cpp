#include "tests/app/program.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace scb {

std::string file_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

ProgramRun run_scb(const std::string& arguments, const std::string& prefix) {
    const TemporaryFolder folder;
    const std::string command = prefix + " " SCB_PROGRAM " " + arguments + " >" + (folder / "out") +
                                " 2>" + (folder / "err") + " </dev/null";
    const int status = std::system(command.c_str());
    ProgramRun run;
    run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.out = file_text(folder / "out");
    run.err = file_text(folder / "err");
    return run;
}

}  // namespace scb
