#include "tests/app/program.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "render/files/output_file.h"

namespace scb::app {

std::string file_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    render::write_file_whole(path, text);
}

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
}

std::size_t lines_of(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::size_t files_in(const std::filesystem::path& folder) {
    using Entries = std::filesystem::directory_iterator;
    return static_cast<std::size_t>(std::distance(Entries(folder), Entries()));
}

ProgramRun run_scb(const std::string& arguments, const std::string& prefix) {
    const TemporaryFolder folder;
    // The folder of meshes of who runs the tests changes what commands print.
    const std::string command = "unset SCB_MODELS; " + prefix + " " SCB_PROGRAM " " + arguments +
                                " >" + (folder / "out") + " 2>" + (folder / "err") + " </dev/null";
    const int status = std::system(command.c_str());
    ProgramRun run;
    run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.out = file_text(folder / "out");
    run.err = file_text(folder / "err");
    return run;
}

const char* const endless_scene = R"({
  "scb_scene": 1, "name": "endless", "frames": 1000000,
  "models": [{"name": "m", "icosphere": {"subdivisions": 3, "radius": 1}}],
  "bodies": [{"name": "left", "model": "m"},
             {"name": "right", "model": "m", "position": [1.98, 0, 0]}]
})";

}  // namespace scb::app
