#include <memory>

#include "app/cli/commands.h"
#include "app/golden/options.h"
#include "app/golden/results.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/platform/output_file.h"
#include "golden/report/plain_text.h"
#include "golden/suite/baseline.h"

namespace scb::app {
namespace {

std::string compared(const golden::GoldenCase& golden) {
    std::string text;
    for (const auto& [is, name] : {std::pair(golden.counts, "counts"), std::pair(golden.ids, "ids"),
                                   std::pair(golden.colors, "colors")})
        if (is) text += (text.empty() ? "" : ",") + std::string(name);
    return text;
}

bool has_baseline(const golden::GoldenCase& golden, const std::filesystem::path& folder) {
    const golden::CaseFiles files = golden::case_files(folder, golden.name);
    return (!golden.counts || is_there(files.counts)) && (!golden.ids || is_there(files.ids)) &&
           (!golden.colors || is_there(files.image));
}

int run(const GoldenOptions& options) {
    const golden::Suite suite = golden::load_suite(options.suite);
    const std::filesystem::path folder = options.baselines_folder();
    golden::check_readable(folder);
    std::string text;
    for (const golden::GoldenCase& golden : options.chosen(suite))
        text += format("%-36s %-18s %-9s ", golden.name.c_str(), compared(golden).c_str(),
                       has_baseline(golden, folder) ? "" : "MISSING") +
                golden::plain_text(golden::typed(golden, "DIR")) + "\n";
    for (const std::string& file : golden::stray_files(folder, suite))
        text += golden::plain_text((folder / file).string()) + " belongs to no case.\n";
    for (const std::string& file : golden::uncompared_images(folder, suite))
        text += golden::plain_text((folder / file).string()) + " " + why_uncompared + "\n";
    print_result(text);
    return exit_done;
}

}  // namespace

void add_golden_list(const Command& golden, Action& action) {
    const Command command = golden.add_subcommand(
        "list", "List the cases: what is compared, whether there is a baseline, and what is run");
    const auto options = std::make_shared<GoldenOptions>();
    add_suite_options(command, *options);
    command.callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace scb::app
