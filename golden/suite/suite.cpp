#include "golden/suite/suite.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/text_format.h"
#include "core/platform/input_files.h"
#include "core/platform/json_reader.h"
#include "golden/suite/case_command.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"
#include "scenes/scene/scene.h"

namespace scb::golden {
namespace {

/// Larger pictures make large repositories.
constexpr int largest_side = 512;

/// The versions of the format. In the first, pictures have a panel by default. Since the second,
/// pictures of scenes have none by default, and others are large enough that no text is cut.
constexpr int first_version = 1, latest_version = 2;
constexpr const char *size_of_view = "240x180", *size_with_panel = "512x384";

/// The longest chain of presets.
constexpr std::size_t most_presets = 16;

constexpr std::string_view refused_arguments[] = {
    "--output", "--json",     "--csv",  "--ids",     "--jobs",  "--video",     "--fps",
    "--sheet",  "--no-sheet", "--pick", "--compare", "--steps", "--pairs-out", "--samples",
    "--quiet",  "--color",    "--gl",   "--models",  "--frame", "--frames",    "--volume",
    "--test",   "--size",     "--top",  "--no-panel"};

GoldenRun read_run(const JsonPlace& place) {
    const std::optional<GoldenRun> run = golden_run_names.find(read_text(place));
    if (run) return *run;
    refuse_value(place, "one of " + name_list(golden_run_names.names));
}

std::string read_size(const JsonPlace& place, bool has_panel) {
    const int least_width = has_panel ? 320 : 64, least_height = has_panel ? 240 : 64;
    const std::string text = read_text(place);
    int width = 0, height = 0, end = 0;
    if (std::sscanf(text.c_str(), "%4dx%4d%n", &width, &height, &end) != 2 ||
        static_cast<std::size_t>(end) != text.size() || width < least_width ||
        height < least_height || width > largest_side || height > largest_side)
        refuse_value(place, format("WIDTHxHEIGHT in pixels from %dx%d to %dx%d", least_width,
                                   least_height, largest_side, largest_side));
    return text;
}

std::vector<std::string> read_scenes(const JsonPlace& place) {
    if (!place.value->is_array()) return {read_plain_text(place)};
    const std::size_t count = array_size(place, "a scene or two mesh files");
    if (count < 1 || count > 2) refuse_value(place, "a scene or two mesh files");
    std::vector<std::string> scenes;
    for (std::size_t i = 0; i < count; ++i) scenes.push_back(read_plain_text(element(place, i)));
    return scenes;
}

std::string read_volume(const JsonPlace& place) {
    const std::string text = read_plain_text(place);
    if (text.find(',') != std::string::npos)
        refuse_value(place, "one volume, since a case is of one");
    return text;
}

std::vector<std::string> read_arguments(const JsonPlace& place) {
    std::vector<std::string> arguments;
    const std::size_t count = array_size(place, "a list of words of the command line");
    for (std::size_t i = 0; i < count; ++i) {
        const JsonPlace at = element(place, i);
        const std::string word = read_plain_text(at), option = word.substr(0, word.find('='));
        const bool short_output = option.starts_with("-o");  // -oout too
        if (short_output || std::find(std::begin(refused_arguments), std::end(refused_arguments),
                                      option) != std::end(refused_arguments))
            refuse(at, word +
                           " is not for cases: either they have a field for it, or it says "
                           "where and how something is written; leave it out.");
        arguments.push_back(word);
    }
    return arguments;
}

std::vector<std::string> read_command(const JsonPlace& place) {
    const char* expected = "a list of a command's words, with {} in place of the recording's file";
    std::vector<std::string> words;
    const std::size_t count = array_size(place, expected);
    for (std::size_t i = 0; i < count; ++i) words.push_back(read_plain_text(element(place, i)));
    if (std::none_of(words.begin(), words.end(), [](const std::string& word) {
            return word.find(recording_here) != std::string::npos;
        }))
        refuse_value(place, expected);
    return words;
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
        : json_(parse_json(read_text_file(file.string()), file.string())) {
        const JsonPlace all{&json_, file.string(), ""};
        check_fields(all, {"scb_golden", "presets", "cases"});
        version_ = read_integer(field(all, "scb_golden"), first_version, latest_version);
        if (has(all, "presets")) {
            const JsonPlace presets = field(all, "presets");
            if (!presets.value->is_object()) refuse_value(presets, "an object of presets by name");
            for (const auto& [name, value] : presets.value->items())
                add_preset(name, {&value, presets.file, presets.path + "." + name});
        }
        const JsonPlace cases = field(all, "cases");
        const std::size_t count = array_size(cases, "a list of cases");
        if (count == 0) refuse(cases, "there is no case to check; add one.");
        suite_.file = file;
        for (std::size_t i = 0; i < count; ++i) add(element(cases, i));
    }

    Suite take() { return std::move(suite_); }

  private:
    /// The fields that a case has, also by its presets, and their places.
    using Given = std::map<std::string, JsonPlace>;

    void add_preset(const std::string& name, const JsonPlace& place) {
        check_case_fields(place);
        if (has(place, "name")) refuse(place, "a preset has no name of a case; leave out `name`.");
        presets_[name] = place;
    }

    static void check_case_fields(const JsonPlace& place) {
        check_fields(place, {"name", "preset", "note", "run", "scene", "frames", "volume", "test",
                             "size", "panel", "arguments", "command", "compare", "tolerance"});
    }

    void add(const JsonPlace& place) {
        GoldenCase golden;
        std::set<std::string> seen;
        Given given;
        apply(place, golden, seen, given);
        for (const char* needed : {"name", "run"})
            if (!given.contains(needed)) field(place, needed);
        if (given.contains("command") && given.contains("scene"))
            refuse(place, "`command` makes the recording that is the scene; leave out `scene`.");
        if (!given.contains("command") && !given.contains("scene")) field(place, "scene");
        if (golden.name != scenes::file_name_of(golden.name))
            refuse_value(
                field(place, "name"),
                "letters, digits, '_' and '-', beginning and ending with a letter, a digit "
                "or '_'");
        if (golden.name.find('.') != std::string::npos)
            refuse_value(field(place, "name"),
                         "a name without '.', which parts it from the rest of its files' names");
        if (!names_.insert(golden.name).second)
            refuse(field(place, "name"),
                   "there is a case " + golden.name + " already; give each a name of its own.");
        if (!golden.command.empty()) golden.own_scene = {golden.name + ".scbrec"};
        check_what_is_made(place, golden, given);
        set_size(golden, given);
        suite_.cases.push_back(
            seen_from_here(std::move(golden), suite_.file.parent_path(), std::filesystem::path()));
    }

    /// Outputs that the run cannot make are not compared, and must not be requested.
    void check_what_is_made(const JsonPlace& place, GoldenCase& golden, const Given& given) const {
        const std::string run(golden_run_names[golden.run]);
        const bool recording =
            !golden.command.empty() ||
            (golden.own_scene.size() == 1 &&
             scenes::names_recording((suite_.file.parent_path() / golden.own_scene[0]).string()));
        if (golden.run == GoldenRun::external && !recording)
            refuse(place,
                   "`external` is of a recording, such as engine.scbrec, or of a `command` "
                   "that makes one; give either.");
        if (golden.run == GoldenRun::inspect && recording)
            refuse(place,
                   "`inspect` has no counts of a recording to compare; compare the "
                   "engine's counts with `external`.");
        if (golden.run == GoldenRun::distance && !golden.test.empty())
            refuse(place, "`test` is of queries for overlap, and distance has none; leave it out.");
        const bool ids = has_ids(golden.run), colors = has_picture(golden.run);
        if (given.contains("compare")) {
            if (golden.ids && !ids)
                refuse(place, "`compare` names ids, and " + run + " makes none; leave them out.");
            if (golden.colors && !colors)
                refuse(place,
                       "`compare` names colors, and " + run + " draws none; leave them out.");
        }
        golden.ids &= ids;
        golden.colors &= colors;
        if (given.contains("tolerance") && !golden.colors)
            refuse(place, "there is a tolerance of colors, and none are compared; leave it out.");
        const bool one_frame = golden.frames.find_first_not_of("0123456789") == std::string::npos;
        // A summary of `inspect` is one picture of many frames.
        if (colors && golden.run != GoldenRun::inspect && !one_frame)
            refuse(place, "its frames are " + golden.frames +
                              ", and a picture is of one; give one number, and each further frame "
                              "a case of its own.");
    }

    /// The least size of a picture depends on its panel.
    void set_size(GoldenCase& golden, const Given& given) const {
        if (!has_ids(golden.run))
            golden.panel = true;
        else if (!given.contains("panel"))
            golden.panel = version_ == first_version;
        if (given.contains("size"))
            golden.size = read_size(given.at("size"), golden.panel && has_picture(golden.run));
        else if (version_ > first_version)
            golden.size = golden.panel ? size_with_panel : size_of_view;
    }

    /// First the preset's fields, then its own, which win.
    void apply(const JsonPlace& place, GoldenCase& golden, std::set<std::string>& seen,
               Given& given) {
        check_case_fields(place);
        if (has(place, "preset")) {
            const JsonPlace at = field(place, "preset");
            const std::string name = read_text(at);
            const auto preset = presets_.find(name);
            if (preset == presets_.end())
                refuse(at, "there is no preset " + name + "; see `presets`.");
            if (!seen.insert(name).second) refuse(at, "the preset " + name + " inherits itself.");
            if (seen.size() > most_presets)
                refuse(at, "more than " + std::to_string(most_presets) +
                               " presets take fields over from each other; make the chain "
                               "shorter.");
            apply(preset->second, golden, seen, given);
        }
        for (const auto& item : place.value->items())
            given.insert_or_assign(item.key(), field(place, item.key().c_str()));
        if (has(place, "name")) golden.name = read_plain_text(field(place, "name"));
        if (has(place, "note")) read_text(field(place, "note"));
        if (has(place, "run")) golden.run = read_run(field(place, "run"));
        if (has(place, "scene")) golden.own_scene = read_scenes(field(place, "scene"));
        if (has(place, "frames")) golden.frames = read_plain_text(field(place, "frames"));
        if (has(place, "volume")) golden.volume = read_volume(field(place, "volume"));
        if (has(place, "test")) golden.test = read_plain_text(field(place, "test"));
        if (has(place, "panel")) golden.panel = read_bool(field(place, "panel"));
        if (has(place, "arguments"))
            golden.own_arguments = read_arguments(field(place, "arguments"));
        if (has(place, "command")) golden.command = read_command(field(place, "command"));
        if (has(place, "compare")) read_compare(field(place, "compare"), golden);
        if (has(place, "tolerance")) golden.tolerance = read_tolerance(field(place, "tolerance"));
    }

    nlohmann::json json_;
    std::int64_t version_ = latest_version;
    std::map<std::string, JsonPlace> presets_;
    std::set<std::string> names_;
    Suite suite_;
};

}  // namespace

bool has_picture(GoldenRun run) {
    return run != GoldenRun::collide && run != GoldenRun::distance && run != GoldenRun::external;
}

bool has_ids(GoldenRun run) {
    return run == GoldenRun::levels || run == GoldenRun::pairs || run == GoldenRun::rejections;
}

Suite load_suite(const std::filesystem::path& file) {
    note_input(file);
    std::error_code ignored;
    if (std::filesystem::status(file, ignored).type() == std::filesystem::file_type::not_found)
        throw InputError(file.string() +
                         ": there is no such file; name your suite with --suite FILE.json, or "
                         "write a first one with `scb golden init`.");
    return Reader(file).take();
}

}  // namespace scb::golden
