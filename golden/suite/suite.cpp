#include "golden/suite/suite.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "golden/suite/case_command.h"
#include "scb/error.h"
#include "scenes/scene/scene.h"
#include "scenes/text/json_reader.h"

namespace scb {
namespace {

constexpr std::pair<GoldenRun, std::string_view> runs[] = {
    {GoldenRun::levels, "levels"},         {GoldenRun::pairs, "pairs"},
    {GoldenRun::rejections, "rejections"}, {GoldenRun::traversal, "traversal"},
    {GoldenRun::inspect, "inspect"},       {GoldenRun::collide, "collide"}};

/// Larger pictures make large repositories.
constexpr int largest_side = 512;

/// That follow each other.
constexpr std::size_t most_presets = 16;

constexpr std::string_view refused_arguments[] = {
    "--output",    "--json",    "--csv",      "--ids",   "--jobs",    "--video",
    "--fps",       "--sheet",   "--no-sheet", "--pick",  "--compare", "--steps",
    "--pairs-out", "--samples", "--quiet",    "--color", "--gl",      "--models",
    "--frame",     "--frames",  "--volume",   "--test",  "--size",    "--top"};

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
        read_integer(field(all, "scb_golden"), 1, 1);
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
    void add_preset(const std::string& name, const JsonPlace& place) {
        check_case_fields(place);
        if (has(place, "name")) refuse(place, "a preset has no name of a case; leave out `name`.");
        presets_[name] = place;
    }

    static void check_case_fields(const JsonPlace& place) {
        check_fields(place, {"name", "preset", "note", "run", "scene", "frames", "volume", "test",
                             "size", "arguments", "compare", "tolerance"});
    }

    void add(const JsonPlace& place) {
        GoldenCase golden;
        std::set<std::string> seen, given;
        apply(place, golden, seen, given);
        for (const char* needed : {"name", "run", "scene"})
            if (!given.contains(needed)) field(place, needed);
        if (golden.name != file_name_of(golden.name))
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
        check_what_is_made(place, golden, given);
        suite_.cases.push_back(
            seen_from_here(std::move(golden), suite_.file.parent_path(), std::filesystem::path()));
    }

    /// What the run cannot make is not compared, and must not be asked for.
    static void check_what_is_made(const JsonPlace& place, GoldenCase& golden,
                                   const std::set<std::string>& given) {
        const std::string run(golden_run_name(golden.run));
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

    /// First the preset's fields, then its own, which win.
    void apply(const JsonPlace& place, GoldenCase& golden, std::set<std::string>& seen,
               std::set<std::string>& given) {
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
        for (const auto& item : place.value->items()) given.insert(item.key());
        if (has(place, "name")) golden.name = read_plain_text(field(place, "name"));
        if (has(place, "note")) read_text(field(place, "note"));
        if (has(place, "run")) golden.run = read_run(field(place, "run"));
        if (has(place, "scene")) golden.own_scene = read_scenes(field(place, "scene"));
        if (has(place, "frames")) golden.frames = read_plain_text(field(place, "frames"));
        if (has(place, "volume")) golden.volume = read_volume(field(place, "volume"));
        if (has(place, "test")) golden.test = read_plain_text(field(place, "test"));
        if (has(place, "size")) golden.size = read_size(field(place, "size"));
        if (has(place, "arguments"))
            golden.own_arguments = read_arguments(field(place, "arguments"));
        if (has(place, "compare")) read_compare(field(place, "compare"), golden);
        if (has(place, "tolerance")) golden.tolerance = read_tolerance(field(place, "tolerance"));
    }

    nlohmann::json json_;
    std::map<std::string, JsonPlace> presets_;
    std::set<std::string> names_;
    Suite suite_;
};

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

Suite load_suite(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        throw InputError(file.string() + ": there is no such file; name your suite with --suite.");
    return Reader(file).take();
}

}  // namespace scb
