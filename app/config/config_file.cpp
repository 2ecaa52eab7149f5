#include "app/config/config_file.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "app/reference/words.h"
#include "core/platform/input_files.h"
#include "core/platform/json_reader.h"
#include "core/platform/number_list.h"
#include "scb/error.h"

namespace scb::app {
namespace {

std::vector<std::filesystem::path> config_paths() {
    std::vector<std::filesystem::path> paths = {"scb.json"};
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::filesystem::path(value == nullptr ? "" : value);
    };
    // The XDG Base Directory Specification ignores relative paths.
    if (const auto folder = variable("XDG_CONFIG_HOME"); folder.is_absolute())
        paths.push_back(folder / "scb/config.json");
    else if (const auto home = variable("HOME"); home.is_absolute())
        paths.push_back(home / ".config/scb/config.json");
    return paths;
}

/// A number, a text or a truth value in the form of a command line.
std::string value_text(const JsonPlace& place, const ReferenceOption& option) {
    if (!option.takes_value) return read_bool(place) ? "true" : "false";
    if (place.value->is_number()) return place.value->dump();
    if (!place.value->is_array()) return read_plain_text(place);
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < array_size(place, "a list"); ++i)
        parts.push_back(value_text(element(place, i), option));
    if (parts.empty()) refuse(place, "the list is empty; give a value, or leave it out.");
    return joined(parts, ",");
}

/// The option of any of the commands; they agree on what is used of it here.
const ReferenceOption& known_option(const JsonPlace& place, const std::string& section,
                                    const std::string& name,
                                    const std::vector<const ReferenceCommand*>& commands) {
    bool is_only_typed = false;
    for (const ReferenceCommand* command : commands) {
        if (const ReferenceOption* option = configurable(*command, name)) return *option;
        for (const ReferenceOption& option : command->options)
            is_only_typed |= option.has_name(name);
    }
    if (is_only_typed)
        refuse(place, "no file may give " + name +
                          ", for it says what is written or run; give it on the command "
                          "line.");
    refuse(place, "there is no option " + name + " of " +
                      (section == "*" ? "any command" : "`scb " + section + "`") + "; see `scb " +
                      (section == "*" ? "" : section + " ") + "--help`.");
}

void read_section(const JsonPlace& place, const std::string& section,
                  const ReferenceCommand& program, std::vector<Setting>& settings) {
    if (!place.value->is_object())
        refuse_value(place, "an object of options, such as {\"volume\": \"obb\"}");
    Setting setting{place.file, section, "", ""};
    std::vector<const ReferenceCommand*> commands;
    for (const ReferenceCommand* command : all_commands(program))
        if (command->commands.empty() && setting.reaches(*command)) commands.push_back(command);
    if (commands.empty())
        refuse(place,
               "there is no command of that name; give one that `scb --help` "
               "lists, such as \"collide\" or \"render levels\", or \"*\".");
    for (const auto& [key, value] : place.value->items()) {
        const JsonPlace at{&value, place.file, place.path + "." + key};
        const ReferenceOption& option = known_option(at, section, "--" + key, commands);
        setting.name = option.names.back();
        for (const std::string& name : option.names)
            if (name.starts_with("--")) {
                setting.name = name;
                break;
            }
        setting.value = value_text(at, option);
        for (const std::string& word : split_list(setting.value))
            if (const auto kept = option.values.only_typed.find(word);
                kept != option.values.only_typed.end())
                refuse(at, "no file may give " + setting.name + " " + word + ", for " +
                               kept->second + "; give it on the command line.");
        settings.push_back(setting);
    }
}

std::vector<Setting> read_settings(const std::string& file, const ReferenceCommand& program) {
    constexpr std::size_t largest = std::size_t{1} << 20;
    const nlohmann::json document = parse_json(read_text_file(file, largest), file);
    if (!document.is_object())
        refuse_value({&document, file, ""}, "an object with a section for each command");
    if (document.contains("scb_scene"))
        throw InputError(file +
                         ": this is a scene, and settings have this name; give it another one, or "
                         "add --no-config.");
    std::vector<Setting> settings;
    for (const auto& [section, options] : document.items())
        read_section({&options, file, section}, section, program, settings);
    return settings;
}

}  // namespace

bool Setting::reaches(const ReferenceCommand& command) const {
    // Golden runs must not depend on a file that the user has forgotten.
    if (section == "*") return !(command.name + " ").starts_with("scb golden ");
    return (command.name + " ").starts_with("scb " + section + " ");
}

const ReferenceOption* configurable(const ReferenceCommand& command, const std::string& name) {
    for (const ReferenceOption& option : command.options)
        if (option.has_name(name) && !option.is_only_typed && name != "--help" &&
            name != "--help-all")
            return &option;
    return nullptr;
}

std::vector<ConfigFile> read_config_files(const ReferenceCommand& program) {
    std::vector<ConfigFile> files;
    for (const std::filesystem::path& path : config_paths()) {
        ConfigFile file{path, false, {}};
        std::error_code ignored;
        file.is_there = std::filesystem::exists(path, ignored);
        if (file.is_there) {
            note_input(path);
            file.settings = read_settings(path.string(), program);
        }
        files.push_back(std::move(file));
    }
    return files;
}

std::vector<Setting> settings_of(const ReferenceCommand& command,
                                 const std::vector<ConfigFile>& files) {
    // By option name.
    std::map<std::string, Setting> held;
    for (const ConfigFile& file : files)
        for (const Setting& setting : file.settings) {
            if (!setting.reaches(command) || configurable(command, setting.name) == nullptr)
                continue;
            const auto [known, is_new] = held.try_emplace(setting.name, setting);
            const bool says_more = known->second.file == setting.file &&
                                   setting.section.size() > known->second.section.size();
            if (!is_new && says_more) known->second = setting;
        }
    std::vector<Setting> settings;
    for (const auto& [name, setting] : held) settings.push_back(setting);
    return settings;
}

}  // namespace scb::app
