#include <filesystem>
#include <memory>
#include <vector>

#include "app/cli/choice.h"
#include "app/cli/commands.h"
#include "app/reference/completion_scripts.h"
#include "app/reference/man_page.h"
#include "app/reference/markdown_page.h"
#include "core/base/exit_status.h"
#include "core/platform/output_file.h"

namespace scb::app {
namespace {

using Script = std::string (*)(const ReferenceCommand&);

int write_man_pages(const ReferenceCommand& program, const std::string& folder) {
    for (const ReferenceCommand* command : all_commands(program))
        write_file_whole(std::filesystem::path(folder) / (man_page_name(*command) + ".1"),
                         man_page(*command, program, SCB_VERSION));
    return exit_done;
}

}  // namespace

void add_completion(const Command& program, Action& action) {
    const Command command = program.add_subcommand(
        "completion", "Print the script that completes scb's command line in a shell");
    const auto script = std::make_shared<Script>(nullptr);
    add_choice(command, "SHELL", *script,
               {{"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}},
               "bash, zsh or fish")
        .required()
        .type_name("");
    command.footer(
        "An installed scb needs none of this: its scripts are where shells look for them.\n\n"
        "Examples:\n"
        "  source <(scb completion bash)\n"
        "  scb completion zsh > ~/.zfunc/_scb\n"
        "  scb completion fish > ~/.config/fish/completions/scb.fish");
    command.callback([&action, command, script] {
        action = [command, script] {
            print_result((*script)(reference_of_program(command)));
            return exit_done;
        };
    });
}

void add_man(const Command& program, Action& action) {
    const Command command = program.add_subcommand("man", "Write the manual page of each command");
    command.hide();
    const auto folder = std::make_shared<std::string>();
    command.add_option("-o,--output", *folder, "Folder for the pages").folder().required();
    command.callback([&action, command, folder] {
        action = [command, folder] {
            return write_man_pages(reference_of_program(command), *folder);
        };
    });
}

void add_reference(const Command& program, Action& action) {
    const Command command =
        program.add_subcommand("reference", "Print the options of each command as Markdown");
    command.hide();
    command.callback([&action, command] {
        action = [command] {
            print_result(markdown_page(reference_of_program(command)));
            return exit_done;
        };
    });
}

}  // namespace scb::app
