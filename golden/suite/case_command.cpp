#include "golden/suite/case_command.h"

#include <algorithm>
#include <string_view>

#include "scenes/scene/builtin.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

/// The arguments of a query that a trace records; each has a value.
constexpr std::string_view recorded_arguments[] = {
    "--pose",    "--poses",  "--growth",    "--margin",        "--threshold",
    "--descent", "--bodies", "--max-pairs", "--level",         "--kind",
    "--order",   "--within", "--limit",     "--relative-error"};

void add_option(std::vector<std::string>& command, const char* option, const std::string& value) {
    if (value.empty()) return;
    command.emplace_back(option);
    command.push_back(value);
}

/// The file of that name in the folder.
std::string in_folder(const fs::path& folder, const std::string& name) {
    const std::string path = (folder / name).lexically_normal().string();
    // A leading dash reads as an option.
    return path.starts_with('-') ? "./" + path : path;
}

std::string scene_from_here(const std::string& name, const fs::path& folder,
                            const fs::path& models) {
    if (scenes::find_builtin(name) != nullptr) return name;
    std::error_code ignored;
    const bool in_models = !models.empty() && !fs::exists(folder / name, ignored) &&
                           fs::exists(models / name, ignored);
    return in_folder(in_models ? models : folder, name);
}

/// Arguments may also name a file: a camera, or a log of poses.
std::string argument_from_here(const std::string& word, const fs::path& folder) {
    const std::size_t start = word.starts_with("--") ? word.find('=') + 1 : 0;
    const std::string file = word.substr(start);
    std::error_code ignored;
    const bool may_be_file =
        file.ends_with(".json") || file.ends_with(".csv") || file.ends_with(".txt");
    if (!may_be_file || !fs::is_regular_file(folder / file, ignored)) return word;
    return word.substr(0, start) + in_folder(folder, file);
}

}  // namespace

std::vector<std::string> command_of(const GoldenCase& golden, const fs::path& folder) {
    const std::string name(golden.run == GoldenRun::external ? "trace"
                                                             : golden_run_names[golden.run]);
    std::vector<std::string> command;
    if (has_picture(golden.run) && golden.run != GoldenRun::inspect) command.emplace_back("render");
    command.push_back(name);
    command.insert(command.end(), golden.scene.begin(), golden.scene.end());
    add_option(command, "--frames", golden.frames);
    add_option(command, "--volume", golden.volume);
    add_option(command, "--test", golden.test);
    command.insert(command.end(), golden.arguments.begin(), golden.arguments.end());
    if (!has_picture(golden.run)) {
        command.emplace_back("--json");
        return command;
    }
    add_option(command, "--size", golden.size);
    if (has_ids(golden.run)) {
        add_option(command, "--samples", "1");
        command.emplace_back("--ids");
        if (!golden.panel) command.emplace_back("--no-panel");
    }
    if (golden.run == GoldenRun::pairs || golden.run == GoldenRun::rejections)
        command.emplace_back("--usual-direction");
    if (golden.run == GoldenRun::levels) command.emplace_back("--no-sheet");
    if (golden.run == GoldenRun::inspect) {
        add_option(command, "--top", "1");
        command.emplace_back("--no-view");
    }
    add_option(command, "--jobs", "1");
    add_option(command, "-o", folder.string());
    return command;
}

std::vector<std::string> maker_of(const GoldenCase& golden, const fs::path& file) {
    std::vector<std::string> words = golden.command;
    for (std::string& word : words)
        for (std::size_t at = word.find(recording_here); at != std::string::npos;
             at = word.find(recording_here, at + file.string().size()))
            word.replace(at, std::string_view(recording_here).size(), file.string());
    return words;
}

std::vector<std::string> trace_command_of(const GoldenCase& golden, const std::string& frame,
                                          const fs::path& file) {
    std::vector<std::string> command = {"trace"};
    command.insert(command.end(), golden.scene.begin(), golden.scene.end());
    add_option(command, "--frames", frame);
    add_option(command, "--volume", golden.volume);
    add_option(command, "--test", golden.test);
    if (golden.run == GoldenRun::distance) add_option(command, "--kind", "distance");
    for (std::size_t i = 0; i < golden.arguments.size(); ++i) {
        const std::string& word = golden.arguments[i];
        if (word == "--first" && golden.run == GoldenRun::distance) command.push_back(word);
        const bool alone = word.find('=') == std::string::npos;
        if (std::find(std::begin(recorded_arguments), std::end(recorded_arguments),
                      word.substr(0, word.find('='))) == std::end(recorded_arguments))
            continue;
        command.push_back(word);
        if (alone && i + 1 < golden.arguments.size()) command.push_back(golden.arguments[++i]);
    }
    add_option(command, "-o", file.string());
    return command;
}

GoldenCase in_own_folder(GoldenCase golden) {
    golden.scene = golden.own_scene;
    golden.arguments = golden.own_arguments;
    return golden;
}

GoldenCase seen_from_here(GoldenCase golden, const fs::path& folder, const fs::path& models) {
    golden.scene = golden.own_scene;
    for (std::string& name : golden.scene) name = scene_from_here(name, folder, models);
    golden.arguments = golden.own_arguments;
    for (std::string& word : golden.arguments) word = argument_from_here(word, folder);
    return golden;
}

std::string shell_word(const std::string& text) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789%+,-./:=@_";
    const auto is_plain = [&](char c) { return plain.find(c) != std::string_view::npos; };
    if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
    return word + "'";
}

}  // namespace scb::golden
