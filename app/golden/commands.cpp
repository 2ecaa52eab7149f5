#include "app/golden/commands.h"

#include <algorithm>
#include <cstdlib>

#include "app/pictures/picture_options.h"
#include "golden/suite/case_command.h"

namespace scb::app {
namespace {

/// Empty if SCB_MODELS names the same folder for every command.
std::string models_words(const GoldenOptions& options) {
    const char* environment = std::getenv("SCB_MODELS");
    if (options.models.empty() || (environment != nullptr && options.models == environment))
        return "";
    return " --models " + golden::shell_word(options.models);
}

std::string gl_words(const GoldenOptions& options) {
    return options.gl == PictureOptions{}.gl ? "" : " --gl " + golden::shell_word(options.gl);
}

/// A shell finds programs by name; an emulator needs the path.
std::string reproducing(const golden::GoldenCase& golden, const GoldenOptions& options) {
    std::string command = golden::typed(golden::command_of(golden, "out")) + models_words(options);
    if (golden::has_picture(golden.run)) command += gl_words(options);
    const std::string maker = golden::typed_maker(golden);
    if (options.runner.empty()) return maker + command;
    return maker + options.runner + " \"$(command -v scb)\"" + command.substr(command.find(' '));
}

std::string updating(const golden::GoldenCase& golden, const GoldenOptions& options) {
    std::string command =
        "scb golden update" + options.suite_words() + models_words(options) + gl_words(options);
    if (!options.runner.empty()) command += " --runner " + golden::shell_word(options.runner);
    return command + " " + golden::shell_word(golden.name);
}

}  // namespace

const golden::GoldenCase& case_of(const std::string& name,
                                  const std::vector<golden::GoldenCase>& cases) {
    return *std::find_if(cases.begin(), cases.end(),
                         [&](const golden::GoldenCase& golden) { return golden.name == name; });
}

void add_commands(golden::SuiteResult& result, const golden::GoldenCheck& check,
                  const GoldenOptions& options) {
    for (golden::CaseResult& c : result.cases) {
        if (!golden::is_failure(c.verdict)) continue;
        const golden::GoldenCase& golden = case_of(c.name, check.cases);
        c.reproduce = reproducing(golden, options);
        if (golden::has_run(golden, check.folders)) c.update = updating(golden, options);
    }
}

void add_diff_commands(golden::SuiteResult& result, const std::filesystem::path& folder) {
    for (golden::CaseResult& c : result.cases)
        if (c.traces.size() == 2)
            c.diff = golden::typed(
                {"diff", (folder / c.traces[0]).string(), (folder / c.traces[1]).string()});
}

}  // namespace scb::app
