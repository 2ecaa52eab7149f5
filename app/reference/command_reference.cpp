#include "app/reference/command_reference.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace scb::app {
namespace {

ReferenceOption reference_of(const CLI::Option& option, const OptionTable& table) {
    ReferenceOption result;
    for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
    result.help = option.get_description();
    result.default_text = option.get_default_str();
    result.environment = option.get_envname();
    result.takes_value = option.get_items_expected_max() != 0;
    result.takes_several = option.get_expected_max() > 1 && option.get_delimiter() == '\0';
    result.is_only_typed = table.only_typed.contains(&option) || result.takes_several;
    result.is_shareable = table.shareable.contains(&option);
    result.parsed = &option;
    result.is_required = option.get_required();
    if (result.takes_value) result.value = option.get_type_name();
    if (option.get_positional()) result.value = option.get_name();
    if (const auto found = table.values.find(&option); found != table.values.end())
        result.values = found->second;
    return result;
}

ReferenceCommand reference_of(const CLI::App& app, const OptionTable& table,
                              const std::string& parents) {
    ReferenceCommand command;
    command.name = parents + app.get_name();
    command.help = app.get_description();
    command.footer = app.get_footer();
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_group().empty()) continue;
        if (option->get_positional()) command.most_arguments += option->get_expected_max();
        (option->get_positional() ? command.arguments : command.options)
            .push_back(reference_of(*option, table));
    }
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
        if (!sub->get_group().empty())
            command.commands.push_back(reference_of(*sub, table, command.name + " "));
    return command;
}

}  // namespace

bool ReferenceOption::has_name(const std::string& name) const {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string ReferenceCommand::word() const { return name.substr(name.rfind(' ') + 1); }

const ReferenceOption* ReferenceCommand::argument() const {
    if (!arguments.empty()) return &arguments[0];
    const auto several = std::find_if(options.begin(), options.end(),
                                      [](const ReferenceOption& o) { return o.takes_several; });
    return several == options.end() ? nullptr : &*several;
}

ReferenceCommand reference_of_program(const Command& command) {
    const CLI::App* program = &command.app();
    while (program->get_parent() != nullptr) program = program->get_parent();
    return reference_of(*program, command.table(), "");
}

std::vector<const ReferenceCommand*> all_commands(const ReferenceCommand& program) {
    std::vector<const ReferenceCommand*> all = {&program};
    for (const ReferenceCommand& command : program.commands) {
        const std::vector<const ReferenceCommand*> below = all_commands(command);
        all.insert(all.end(), below.begin(), below.end());
    }
    return all;
}

}  // namespace scb::app
