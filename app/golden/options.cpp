#include "app/golden/options.h"

#include <algorithm>
#include <set>
#include <thread>

#include "app/cli/validators.h"
#include "app/pictures/picture_options.h"
#include "app/query/query_options.h"
#include "core/platform/input_files.h"
#include "core/platform/number_list.h"
#include "golden/suite/case_command.h"
#include "scb/error.h"
#include "scenes/meshes/isolated_mesh.h"
#include "scenes/scene/scene_inputs.h"

namespace scb::app {

void GoldenOptions::check() const {
    if (jobs < 0 || jobs > 256)
        throw InputError("--jobs " + std::to_string(jobs) + ": give 1 to 256.");
}

std::filesystem::path GoldenOptions::baselines_folder() const {
    if (!baselines.empty()) return baselines;
    return std::filesystem::path(suite).parent_path() / "baselines";
}

std::vector<golden::GoldenCase> GoldenOptions::chosen(const golden::Suite& all) const {
    std::set<std::string> wanted(names.begin(), names.end());
    std::vector<golden::GoldenCase> cases;
    for (const golden::GoldenCase& golden : all.cases) {
        golden::GoldenCase seen = golden::seen_from_here(golden, all.file.parent_path(), models);
        // Other processes read these files; nothing here may replace them.
        scenes::note_scene_inputs(seen.scene, models);
        for (const std::string& argument : seen.arguments)
            note_input(argument.substr(argument.find('=') + 1));
        if (names.empty() || wanted.erase(golden.name) > 0) cases.push_back(std::move(seen));
    }
    if (!wanted.empty())
        throw InputError(*wanted.begin() + ": " + suite +
                         " has no case of that name; `scb golden list` shows them.");
    return cases;
}

golden::GoldenRunSettings GoldenOptions::settings() const {
    golden::GoldenRunSettings settings;
    std::error_code error;
    const std::filesystem::path program = scenes::mesh_reader();
    settings.program = std::filesystem::canonical(program, error).string();
    if (error)
        throw InputError(program.string() + ", the program that runs the cases, cannot be read (" +
                         error.message() + "); check that /proc is mounted.");
    settings.folder = std::filesystem::absolute(suite).parent_path().string();
    if (!models.empty()) settings.models = std::filesystem::absolute(models).string();
    settings.gl = gl;
    for (const std::string& word : split_list(runner, ' '))
        if (!word.empty()) settings.runner.push_back(word);
    // Programs on PATH keep their names; paths must be absolute, since cases run in another folder.
    if (!settings.runner.empty() && settings.runner[0].find('/') != std::string::npos)
        settings.runner[0] = std::filesystem::absolute(settings.runner[0]).string();
    return settings;
}

std::size_t GoldenOptions::job_count() const {
    return jobs > 0 ? static_cast<std::size_t>(jobs)
                    : std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

std::string GoldenOptions::suite_words() const {
    std::string words;
    if (suite != GoldenOptions{}.suite) words += " --suite " + golden::shell_word(suite);
    if (!baselines.empty()) words += " --baselines " + golden::shell_word(baselines);
    return words;
}

void add_suite_options(const Command& command, GoldenOptions& options) {
    command.add_option("NAME", options.names, "Cases; all of them where none is named")
        .type_name("");
    command.add_option("--suite", options.suite, "The file that describes the cases")
        .only_typed()
        .file({".json"})
        .show_default();
    command
        .add_option("--baselines", options.baselines,
                    "The folder of the baselines; else baselines/ beside the suite")
        .only_typed()
        .folder();
}

void add_golden_options(const Command& command, GoldenOptions& options) {
    add_suite_options(command, options);
    options.gl = PictureOptions{}.gl;
    command
        .add_option(
            "--models", options.models,
            "Folder to search for meshes that are missing beside the suite and their scene file")
        .envname("SCB_MODELS")
        .folder();
    command.add_option("--jobs", options.jobs, "Cases at a time; 0 is one per core")
        .check(decimal_number)
        .type_name("J")
        .show_default();
    command
        .add_option("--runner", options.runner,
                    "Run each case, in the folder of the suite, with this program in front: "
                    "\"qemu-x86_64 -cpu Nehalem\"")
        .only_typed()
        .type_name("WORDS");
    add_gl_option(command, options.gl);
}

}  // namespace scb::app
