#include "golden/suite.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "core/error.h"
#include "scenes/builtin.h"
#include "scenes/json_reader.h"
#include "scenes/scene.h"

namespace scb {
namespace {

constexpr std::pair<GoldenRun, std::string_view> runs[] = {
    {GoldenRun::levels, "levels"},         {GoldenRun::pairs, "pairs"},
    {GoldenRun::rejections, "rejections"}, {GoldenRun::traversal, "traversal"},
    {GoldenRun::inspect, "inspect"},       {GoldenRun::collide, "collide"}};

/// Larger pictures make large repositories.
constexpr int largest_side = 512;

constexpr std::string_view refused_arguments[] = {
    "-o",        "--output", "--json",     "--csv",  "--ids",     "--jobs",  "--video",
    "--fps",     "--sheet",  "--no-sheet", "--pick", "--compare", "--steps", "--pairs-out",
    "--samples", "--quiet",  "--color",    "--gl",   "--models",  "--frame", "--frames",
    "--volume",  "--test",   "--size",     "--top"};

/// What of a query a trace records; each has a value.
constexpr std::string_view recorded_arguments[] = {"--pose",      "--growth",  "--margin",
                                                   "--threshold", "--descent", "--bodies",
                                                   "--max-pairs", "--level"};

std::string list_of_runs() {
    std::string list;
    for (const auto& [run, name] : runs) list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

GoldenRun read_run(const JsonPlace& place) {
    const std::string text = read_text(place);
    for (const auto& [run, name] : runs)
        if (name == text) return run;
    refuse_value(place, "one of " + list_of_runs());
}

std::string read_size(const JsonPlace& place) {
    const std::string text = read_text(place);
    int width = 0, height = 0, end = 0;
    if (std::sscanf(text.c_str(), "%4dx%4d%n", &width, &height, &end) != 2 ||
        static_cast<std::size_t>(end) != text.size() || width < 320 || height < 240 ||
        width > largest_side || height > largest_side)
        refuse_value(place, "WIDTHxHEIGHT in pixels from 320x240 to " +
                                std::to_string(largest_side) + "x" + std::to_string(largest_side));
    return text;
}

/// A built-in scene, or the path of a file, which is relative to that of the suite.
std::string read_scene(const JsonPlace& place, const std::filesystem::path& folder) {
    const std::string text = read_plain_text(place);
    if (find_builtin(text) != nullptr) return text;
    return (folder / text).lexically_normal().string();
}

std::vector<std::string> read_scenes(const JsonPlace& place, const std::filesystem::path& folder) {
    if (!place.value->is_array()) return {read_scene(place, folder)};
    const std::size_t count = array_size(place, "a scene or two mesh files");
    if (count < 1 || count > 2) refuse_value(place, "a scene or two mesh files");
    std::vector<std::string> scenes;
    for (std::size_t i = 0; i < count; ++i) scenes.push_back(read_scene(element(place, i), folder));
    return scenes;
}

std::vector<std::string> read_arguments(const JsonPlace& place) {
    std::vector<std::string> arguments;
    const std::size_t count = array_size(place, "a list of words of the command line");
    for (std::size_t i = 0; i < count; ++i) {
        const JsonPlace at = element(place, i);
        const std::string word = read_plain_text(at), option = word.substr(0, word.find('='));
        if (std::find(std::begin(refused_arguments), std::end(refused_arguments), option) !=
            std::end(refused_arguments))
            refuse(at, word +
                           " is not for cases: either they have a field for it, or it says "
                           "where and how something is written; leave it out.");
        arguments.push_back(word);
    }
    return arguments;
}

void read_compare(const JsonPlace& place, GoldenCase& golden) {
    const char* expected = "a list of some of counts, ids, colors";
    golden.counts = golden.ids = golden.colors = false;
    const std::size_t count = array_size(place, expected);
    if (count == 0) refuse_value(place, expected);
    for (std::size_t i = 0; i < count; ++i) {
        const JsonPlace at = element(place, i);
        const std::string what = read_text(at);
        if (what == "counts")
            golden.counts = true;
        else if (what == "ids")
            golden.ids = true;
        else if (what == "colors")
            golden.colors = true;
        else
            refuse_value(at, "counts, ids or colors");
    }
}

ColorTolerance read_tolerance(const JsonPlace& place) {
    check_fields(place, {"max_channel_delta", "max_pixels"});
    return {static_cast<int>(read_integer(field(place, "max_channel_delta"), 0, 255)),
            static_cast<std::size_t>(
                read_integer(field(place, "max_pixels"), 0, largest_side * largest_side))};
}

class Reader {
  public:
    explicit Reader(const std::filesystem::path& file)
        : folder_(file.parent_path()),
          json_(parse_json(read_text_file(file.string()), file.string())) {
        const JsonPlace all{&json_, file.string(), ""};
        check_fields(all, {"scb_golden", "presets", "cases"});
        read_integer(field(all, "scb_golden"), 1, 1);
        if (has(all, "presets")) {
            const JsonPlace presets = field(all, "presets");
            for (const auto& [name, value] : presets.value->items())
                presets_[name] = {&value, presets.file, presets.path + "." + name};
        }
        const JsonPlace cases = field(all, "cases");
        const std::size_t count = array_size(cases, "a list of cases");
        suite_.file = file;
        for (std::size_t i = 0; i < count; ++i) add(element(cases, i));
    }

    Suite take() { return std::move(suite_); }

  private:
    void add(const JsonPlace& place) {
        GoldenCase golden;
        std::set<std::string> seen, given;
        apply(place, golden, seen, given);
        for (const char* needed : {"name", "run", "scene"})
            if (!given.contains(needed)) field(place, needed);
        if (golden.name != file_name_of(golden.name))
            refuse_value(field(place, "name"),
                         "letters, digits, '.', '_' and '-', beginning and ending with a letter or "
                         "a digit");
        if (!names_.insert(golden.name).second)
            refuse(field(place, "name"),
                   "there is a case " + golden.name + " already; give each a name of its own.");
        if (!has_ids(golden.run)) golden.ids = false;
        if (!has_picture(golden.run)) golden.colors = false;
        if (!golden.counts && !golden.ids && !golden.colors)
            refuse(place, "nothing is compared: " + std::string(golden_run_name(golden.run)) +
                              " makes none of what `compare` names.");
        suite_.cases.push_back(std::move(golden));
    }

    /// First the preset's fields, then its own, which win.
    void apply(const JsonPlace& place, GoldenCase& golden, std::set<std::string>& seen,
               std::set<std::string>& given) {
        check_fields(place, {"name", "preset", "note", "run", "scene", "frames", "volume", "test",
                             "size", "arguments", "compare", "tolerance"});
        if (has(place, "preset")) {
            const JsonPlace at = field(place, "preset");
            const std::string name = read_text(at);
            const auto preset = presets_.find(name);
            if (preset == presets_.end())
                refuse(at, "there is no preset " + name + "; see `presets`.");
            if (!seen.insert(name).second) refuse(at, "the preset " + name + " inherits itself.");
            if (has(preset->second, "name"))
                refuse(preset->second, "a preset has no name of a case; leave out `name`.");
            apply(preset->second, golden, seen, given);
        }
        for (const auto& item : place.value->items()) given.insert(item.key());
        if (has(place, "name")) golden.name = read_plain_text(field(place, "name"));
        if (has(place, "note")) read_text(field(place, "note"));
        if (has(place, "run")) golden.run = read_run(field(place, "run"));
        if (has(place, "scene")) golden.scene = read_scenes(field(place, "scene"), folder_);
        if (has(place, "frames")) golden.frames = read_plain_text(field(place, "frames"));
        if (has(place, "volume")) golden.volume = read_plain_text(field(place, "volume"));
        if (has(place, "test")) golden.test = read_plain_text(field(place, "test"));
        if (has(place, "size")) golden.size = read_size(field(place, "size"));
        if (has(place, "arguments")) golden.arguments = read_arguments(field(place, "arguments"));
        if (has(place, "compare")) read_compare(field(place, "compare"), golden);
        if (has(place, "tolerance")) golden.tolerance = read_tolerance(field(place, "tolerance"));
    }

    std::filesystem::path folder_;
    nlohmann::json json_;
    std::map<std::string, JsonPlace> presets_;
    std::set<std::string> names_;
    Suite suite_;
};

void add_option(std::vector<std::string>& command, const char* option, const std::string& value) {
    if (value.empty()) return;
    command.emplace_back(option);
    command.push_back(value);
}

}  // namespace

std::string_view golden_run_name(GoldenRun run) {
    for (const auto& [r, name] : runs)
        if (r == run) return name;
    return "";
}

bool has_picture(GoldenRun run) { return run != GoldenRun::collide; }

bool has_ids(GoldenRun run) {
    return run == GoldenRun::levels || run == GoldenRun::pairs || run == GoldenRun::rejections;
}

Suite load_suite(const std::filesystem::path& file) { return Reader(file).take(); }

std::vector<std::string> command_of(const GoldenCase& golden, const std::filesystem::path& folder) {
    const std::string name(golden_run_name(golden.run));
    std::vector<std::string> command;
    if (golden.run != GoldenRun::inspect && golden.run != GoldenRun::collide)
        command.emplace_back("render");
    command.push_back(name);
    command.insert(command.end(), golden.scene.begin(), golden.scene.end());
    add_option(command, golden.run == GoldenRun::levels ? "--frame" : "--frames", golden.frames);
    add_option(command, "--volume", golden.volume);
    add_option(command, "--test", golden.test);
    command.insert(command.end(), golden.arguments.begin(), golden.arguments.end());
    if (!has_picture(golden.run)) {
        command.emplace_back("--json");
        return command;
    }
    add_option(command, "--size", golden.size.empty() ? "320x240" : golden.size);
    if (has_ids(golden.run)) {
        add_option(command, "--samples", "1");
        command.emplace_back("--ids");
    }
    if (golden.run == GoldenRun::levels) command.emplace_back("--no-sheet");
    if (golden.run == GoldenRun::inspect) add_option(command, "--top", "1");
    add_option(command, "--jobs", "1");
    add_option(command, "-o", folder.string());
    return command;
}

std::vector<std::string> trace_command_of(const GoldenCase& golden,
                                          const std::filesystem::path& file) {
    const bool one_frame = !golden.frames.empty() &&
                           golden.frames.find_first_not_of("0123456789") == std::string::npos;
    if (golden.run == GoldenRun::levels || !one_frame) return {};
    std::vector<std::string> command = {"trace"};
    command.insert(command.end(), golden.scene.begin(), golden.scene.end());
    add_option(command, "--frames", golden.frames);
    add_option(command, "--volume", golden.volume);
    add_option(command, "--test", golden.test);
    for (std::size_t i = 0; i < golden.arguments.size(); ++i) {
        const std::string& word = golden.arguments[i];
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

}  // namespace scb
