#include <memory>

#include "app/cli/commands.h"
#include "app/cli/exit_status.h"
#include "app/golden/options.h"
#include "app/golden/results.h"
#include "core/base/text_format.h"
#include "golden/report/plain_text.h"
#include "golden/suite/baseline.h"
#include "golden/suite/files_equal.h"

namespace scb {
namespace {

std::string compared(const GoldenCase& golden) {
    std::string text;
    for (const auto& [is, name] : {std::pair(golden.counts, "counts"), std::pair(golden.ids, "ids"),
                                   std::pair(golden.colors, "colors")})
        if (is) text += (text.empty() ? "" : ",") + std::string(name);
    return text;
}

bool has_baseline(const GoldenCase& golden, const std::filesystem::path& folder) {
    const CaseFiles files = case_files(folder, golden.name);
    return (!golden.counts || is_there(files.counts)) && (!golden.ids || is_there(files.ids)) &&
           (!golden.colors || is_there(files.image));
}

int run(const GoldenOptions& options) {
    const Suite suite = load_suite(options.suite);
    const std::filesystem::path folder = options.baselines_folder();
    check_readable(folder);
    std::string text;
    for (const GoldenCase& golden : options.chosen(suite))
        text += format("%-36s %-18s %-9s ", golden.name.c_str(), compared(golden).c_str(),
                       has_baseline(golden, folder) ? "" : "MISSING") +
                plain_text(typed(command_of(golden, "DIR"))) + "\n";
    for (const std::string& file : stray_files(folder, suite))
        text += plain_text((folder / file).string()) + " belongs to no case.\n";
    for (const std::string& file : uncompared_images(folder, suite))
        text += plain_text((folder / file).string()) + " " + why_uncompared + "\n";
    print_result(text);
    return exit_done;
}

}  // namespace

void add_golden_list(CLI::App& golden, Action& action) {
    CLI::App* command = golden.add_subcommand(
        "list", "The cases: what is compared, whether there is a baseline, and what is run");
    const auto options = std::make_shared<GoldenOptions>();
    add_suite_options(*command, *options);
    command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace scb
