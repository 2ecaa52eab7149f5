#include "app/golden/commands.h"

#include <algorithm>
#include <cstdlib>

#include "app/pictures/picture_options.h"
#include "golden/suite/shell_word.h"

namespace scb {
namespace {

/// Empty where the environment tells every command the same.
std::string models_words(const GoldenOptions& options) {
    const char* environment = std::getenv("SCB_MODELS");
    if (options.models.empty() || (environment != nullptr && options.models == environment))
        return "";
    return " --models " + shell_word(options.models);
}

std::string gl_words(const GoldenOptions& options) {
    return options.gl == PictureOptions{}.gl ? "" : " --gl " + shell_word(options.gl);
}

/// The shell finds programs by their names, an emulator does not.
std::string reproducing(const GoldenCase& golden, const GoldenOptions& options) {
    std::string command = typed(command_of(golden, "out")) + models_words(options);
    if (has_picture(golden.run)) command += gl_words(options);
    if (options.runner.empty()) return command;
    return options.runner + " \"$(command -v scb)\"" + command.substr(command.find(' '));
}

std::string updating(const GoldenCase& golden, const GoldenOptions& options) {
    std::string command =
        "scb golden update" + options.suite_words() + models_words(options) + gl_words(options);
    if (!options.runner.empty()) command += " --runner " + shell_word(options.runner);
    return command + " " + shell_word(golden.name);
}

}  // namespace

const GoldenCase& case_of(const std::string& name, const std::vector<GoldenCase>& cases) {
    return *std::find_if(cases.begin(), cases.end(),
                         [&](const GoldenCase& golden) { return golden.name == name; });
}

void add_commands(SuiteResult& result, const GoldenCheck& check, const GoldenOptions& options) {
    for (CaseResult& c : result.cases) {
        if (!is_failure(c.verdict)) continue;
        const GoldenCase& golden = case_of(c.name, check.cases);
        c.reproduce = reproducing(golden, options);
        if (has_run(golden, check.folders)) c.update = updating(golden, options);
    }
}

void add_diff_commands(SuiteResult& result, const std::filesystem::path& folder) {
    for (CaseResult& c : result.cases)
        if (c.traces.size() == 2)
            c.diff =
                typed({"diff", (folder / c.traces[0]).string(), (folder / c.traces[1]).string()});
}

}  // namespace scb
