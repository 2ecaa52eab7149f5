#include "app/config/config.h"

#include <algorithm>
#include <cstdlib>

#include "app/query/query_options.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {
namespace {

/// Whether the query is recorded: then defaults of query options do not apply.
bool is_recorded(const CommandLine& line) {
    return line.has("--pairs") ||
           std::any_of(line.arguments.begin(), line.arguments.end(), [](const std::string& name) {
               return scenes::names_trace(name) || scenes::names_recording(name);
           });
}

bool is_about_scb(const ReferenceCommand& command) {
    return command.name == "scb config" || command.name == "scb doctor" ||
           command.name == "scb completion";
}

}  // namespace

ConfiguredLine configured(const CommandLine& line, const ReferenceCommand& program,
                          OptionTable& table) {
    ConfiguredLine result{line.words, {}};
    const ReferenceCommand& command = *line.command;
    const auto given = [&](const char* option) {
        const auto known =
            std::find_if(program.options.begin(), program.options.end(),
                         [&](const ReferenceOption& named) { return named.has_name(option); });
        return known != program.options.end() && line.given.contains(known->parsed);
    };
    if (!command.commands.empty() || is_about_scb(command) || given("--no-config") ||
        given("--version") || line.has("--help") || line.has("--help-all"))
        return result;
    const std::vector<std::string>& of_query = recording_options();
    for (const Setting& setting : settings_of(command, read_config_files(program))) {
        const ReferenceOption& option = *configurable(command, setting.name);
        const char* variable =
            option.environment.empty() ? nullptr : std::getenv(option.environment.c_str());
        const bool is_of_query =
            std::find(of_query.begin(), of_query.end(), setting.name) != of_query.end();
        if (line.given.contains(option.parsed) || (variable != nullptr && *variable != '\0') ||
            (!option.takes_value && setting.value == "false") || (is_of_query && is_recorded(line)))
            continue;
        result.words.insert(result.words.begin() + static_cast<std::ptrdiff_t>(line.options_begin),
                            option.takes_value ? setting.name + "=" + setting.value : setting.name);
        result.settings.push_back(setting);
        table.from_file.insert(option.parsed);
    }
    return result;
}

std::string ConfiguredLine::placed(const std::string& sentence) const {
    for (const Setting& setting : settings) {
        const std::size_t at = sentence.find(setting.name);
        const std::size_t end = at + setting.name.size();
        // The text may be the beginning of another option's name.
        if (at != sentence.npos && (end == sentence.size() ||
                                    std::string(" :,;").find(sentence[end]) != std::string::npos))
            return setting.file + ": " + setting.section + "." + setting.name.substr(2) + ": " +
                   sentence;
    }
    return sentence;
}

std::string ConfiguredLine::note() const {
    std::string options;
    for (const Setting& setting : settings)
        if (setting.file == "scb.json")
            options += (options.empty() ? "" : ", ") + setting.name +
                       (setting.value == "true" ? "" : " " + setting.value);
    return options.empty() ? "" : "scb: scb.json gives " + options + " (--no-config: not).";
}

}  // namespace scb::app
