#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/config/config_file.h"
#include "app/reference/words.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"

namespace scb::app {
namespace {

/// A setting in effect for one command, and its source: a file with its section, or an environment
/// variable.
struct Held {
    std::string command, option, value, source;
};

std::vector<Held> held_settings(const ReferenceCommand& program,
                                const std::vector<ConfigFile>& files) {
    std::vector<Held> all;
    for (const ReferenceCommand* command : all_commands(program)) {
        if (!command->commands.empty()) continue;
        for (const Setting& setting : settings_of(*command, files)) {
            const std::string& variable = configurable(*command, setting.name)->environment;
            if (!variable.empty() && std::getenv(variable.c_str()) != nullptr) continue;
            all.push_back({command->name, setting.name, setting.value,
                           setting.file + ": " + setting.section});
        }
        for (const ReferenceOption& option : command->options)
            if (const char* value =
                    option.environment.empty() ? nullptr : std::getenv(option.environment.c_str()))
                all.push_back({command->name, option.names.back(), value, option.environment});
    }
    return all;
}

std::string text_of(const std::vector<ConfigFile>& files, const std::vector<Held>& held) {
    std::string text = "Files, of which the first that says something holds:\n";
    for (const ConfigFile& file : files)
        text += "  " + file.path.string() + (file.is_there ? "" : " (not there)") + "\n";
    if (held.empty()) return text + "\nNothing is set.\n";
    // List a setting once for all commands that share it.
    std::map<std::vector<std::string>, std::vector<std::string>> commands;
    for (const Held& setting : held)
        commands[{setting.option, setting.value, setting.source}].push_back(
            setting.command.substr(setting.command.find(' ') + 1));
    text += "\nWhat holds, where the command line says nothing:\n";
    for (const auto& [setting, names] : commands)
        text += "  " + setting[0] + " " + setting[1] + "\n      from " + setting[2] +
                "\n      for " + joined(names, ", ") + "\n";
    return text;
}

std::string json_of(const std::vector<ConfigFile>& files, const std::vector<Held>& held) {
    using Json = nlohmann::ordered_json;
    Json result = {{"files", Json::array()}, {"settings", Json::array()}};
    for (const ConfigFile& file : files)
        result["files"].push_back({{"file", file.path.string()}, {"is_there", file.is_there}});
    for (const Held& setting : held)
        result["settings"].push_back({{"command", setting.command},
                                      {"option", setting.option},
                                      {"value", setting.value},
                                      {"from", setting.source}});
    return result.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

void add_config(const Command& program, const bool& without_files, Action& action) {
    const Command command = program.add_subcommand(
        "config",
        "Show the settings of configuration files and the environment, and where each is set");
    const auto json = std::make_shared<bool>(false);
    command.add_flag("--json", *json, "Print JSON instead of text");
    command.footer(
        "scb.json in the working folder, and ~/.config/scb/config.json, hold defaults of options "
        "by command.\n\nExample:\n  scb config");
    command.callback([&action, &without_files, command, json] {
        action = [&without_files, command, json] {
            const ReferenceCommand reference = reference_of_program(command);
            const std::vector<ConfigFile> files =
                without_files ? std::vector<ConfigFile>{} : read_config_files(reference);
            const std::vector<Held> held = held_settings(reference, files);
            print_result(*json ? json_of(files, held) : text_of(files, held));
            return exit_done;
        };
    });
}

}  // namespace scb::app
