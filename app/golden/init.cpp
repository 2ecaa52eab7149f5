#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "app/cli/choice.h"
#include "app/cli/commands.h"
#include "app/golden/init_suite.h"
#include "app/golden/init_workflows.h"
#include "app/golden/options.h"
#include "core/base/exit_status.h"
#include "golden/report/plain_text.h"
#include "golden/suite/case_command.h"
#include "render/gl/embedded.h"
#include "scb/error.h"

SCB_DECLARE_EMBEDDED(golden_gitattributes)

namespace scb::app {
namespace {

namespace fs = std::filesystem;

struct InitOptions {
    SceneOptions scene;
    InitCi ci = InitCi::github;
    std::string folder = "golden", repository = some_repository;
};

/// The default scene: two bodies, quickly drawn, which reveal every error of the selftest.
constexpr const char* first_scene = "knots-l1";

bool plain(const std::string& text, std::string_view more) {
    return std::all_of(text.begin(), text.end(), [&](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               more.find(c) != std::string_view::npos;
    });
}

/// The path from the working folder; for a file elsewhere it begins with "..".
fs::path from_here(const fs::path& file) {
    return fs::weakly_canonical(fs::absolute(file)).lexically_proximate(fs::canonical("."));
}

bool is_outside(const fs::path& file) {
    const fs::path seen = from_here(file);
    return seen.is_absolute() || (!seen.empty() && *seen.begin() == "..");
}

/// Refuses options that CI cannot use as intended.
void check_for_ci(const InitOptions& options, const FirstSuite& suite) {
    if (options.ci == InitCi::none) return;
    const std::string& name = options.repository;
    if (!plain(name, "_.-/") || std::count(name.begin(), name.end(), '/') != 1 ||
        name.starts_with('/') || name.ends_with('/'))
        throw InputError("--scb " + golden::plain_text(name) +
                         ": give the repository of scb on GitHub as OWNER/NAME.");
    if (!plain(options.folder, "_.-/") || options.folder.starts_with('-'))
        throw InputError("-o " + golden::plain_text(options.folder) +
                         ": files of CI name this folder; give one of letters, digits and _.-/, or "
                         "use --ci none.");
    if (is_outside(options.folder))
        throw InputError("-o " + options.folder +
                         ": CI has only the repository, and this is outside of the folder where "
                         "you are; give a folder in it, or use --ci none.");
    for (const fs::path& file : suite.files)
        if (is_outside(file))
            throw InputError(golden::plain_text(file.string()) +
                             ": CI has only the repository, and this file is outside of the folder "
                             "where you are; copy it there, or use --ci none.");
    // If this is no repository yet, this folder will be its root.
    const fs::path here = fs::canonical(".");
    if (fs::exists(here / ".git")) return;
    for (fs::path folder = here; folder != folder.parent_path(); folder = folder.parent_path())
        if (fs::exists(folder.parent_path() / ".git"))
            throw InputError("CI reads its files at the root of the repository, which is " +
                             golden::plain_text(folder.parent_path().string()) +
                             "; start there, or use --ci none.");
}

/// The commands to type next.
std::string next_steps(const InitOptions& options, const FirstSuite& suite,
                       const std::vector<NewFile>& workflows) {
    GoldenOptions golden;
    golden.suite = (fs::path(options.folder) / "cases.json").string();
    std::string added = " " + golden::shell_word(options.folder);
    for (const NewFile& file : workflows) added += " " + golden::shell_word(file.path.string());
    for (const fs::path& file : suite.files)
        if (!is_outside(file)) added += " " + golden::shell_word(from_here(file).string());
    const char* environment = std::getenv("SCB_MODELS");
    std::string words = golden.suite_words();
    if (!options.scene.models_dir.empty() &&
        (environment == nullptr || options.scene.models_dir != environment))
        words += " --models " + golden::shell_word(options.scene.models_dir);
    std::string text = "Next:\n  scb golden update --all" + words + "\n  git add" + added +
                       "\n  scb golden check" + words + " --report out/report\n";
    if (!workflows.empty() && options.repository == some_repository)
        text += "In the files of CI, write the repository that has scb in place of " +
                std::string(some_repository) + ".\n";
    for (const NewFile& file : workflows)
        if (file.path == gitlab_included)
            text += ".gitlab-ci.yml is there already; add to it: include: [{local: " +
                    std::string(gitlab_included) + "}]\n";
    return text;
}

int run(InitOptions options) {
    if (options.scene.names.empty()) options.scene.names = {first_scene};
    if (options.folder.empty()) throw InputError("-o '': give the folder of the suite.");
    options.folder = fs::path(options.folder).lexically_normal().string();
    if (options.folder.size() > 1 && options.folder.ends_with('/')) options.folder.pop_back();
    const fs::path folder = options.folder;
    const FirstSuite suite = first_suite(options.scene, folder);
    check_for_ci(options, suite);
    const std::vector<NewFile> workflows =
        workflow_files(options.ci, (folder / "cases.json").string(), options.repository);
    std::vector<NewFile> files = {
        {folder / "cases.json", suite.text},
        {folder / "baselines/.gitattributes", std::string(SCB_EMBEDDED(golden_gitattributes))}};
    files.insert(files.end(), workflows.begin(), workflows.end());
    refuse_taken(files);
    write_new_files(files);
    std::string text;
    for (const NewFile& file : files) text += golden::plain_text(file.path.string()) + "\n";
    print_result(text + next_steps(options, suite, workflows));
    return exit_done;
}

}  // namespace

void add_golden_init(const Command& golden, Action& action) {
    const Command command = golden.add_subcommand(
        "init", "Write a first suite of a scene, and what has it checked by CI");
    const auto options = std::make_shared<InitOptions>();
    add_scene_options(command, options->scene, false);
    command.get_option("SCENE").required(false).description(
        "A built-in scene (see `scb scenes`), a scene file, or two mesh files");
    for (const char* of_recordings : {"--query", "--tag"}) command.get_option(of_recordings).hide();
    add_choice(command, "--ci", options->ci, choices_of(init_ci_names),
               "CI files to write: a workflow of GitHub Actions, or jobs of GitLab")
        .only_typed();
    command.add_option("-o,--output", options->folder, "The folder of the suite")
        .folder()
        .only_typed()
        .show_default();
    command
        .add_option("--scb", options->repository,
                    "The repository on GitHub whose action and releases CI uses")
        .type_name("OWNER/NAME")
        .only_typed()
        .show_default();
    command.footer(
        "Writes cases.json and baselines/ in the folder of the suite. Nothing is overwritten. If "
        "there is a .gitlab-ci.yml, the\n"
        "jobs go to .gitlab/scb-golden.yml. Without a SCENE it is the built-in scene knots-l1.\n\n"
        "Examples:\n"
        "  scb golden init parts/bracket.json\n"
        "  scb golden init a.ply b.ply --pose 1,0,0,2,0,1,0,0,0,0,1,0 --ci both -o tests/golden");
    command.callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace scb::app
