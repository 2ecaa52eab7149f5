#include "app/study/scene_setup.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/base/parallel_for.h"
#include "core/base/text_format.h"
#include "core/platform/near_word.h"
#include "core/platform/number_list.h"
#include "core/platform/utf8.h"
#include "scb/error.h"
#include "scenes/recordings/recording.h"
#include "scenes/recordings/recording_input.h"
#include "scenes/scene/pose_rows.h"

namespace scb::app {

scenes::Scene SceneOptions::load(const std::string& list_of_frames) const {
    if (given) return *given;
    for (const std::string& name : names)
        if (scenes::names_trace(name) && std::filesystem::exists(name))
            throw InputError(
                name +
                ": this is a trace, and a scene or meshes are needed here; give a trace "
                "alone to `scb trace`, `render`, `inspect` or `explain`, or two to "
                "`scb diff`, `render pairs` or `render rejections`.");
    if (is_recording()) {
        for (const auto& [option, is_given] :
             {std::pair("--pose", !pose.empty()), std::pair("--poses", !poses.empty())})
            if (is_given)
                throw InputError(std::string(option) + ": " + names[0] +
                                 " is recorded, and has its poses; leave out " + option + ".");
        return scenes::scene_of_recording(names[0], list_of_frames, selection);
    }
    if (!selection.empty())
        throw InputError(selection.words() +
                         ": queries of a recording have names and tags, and this is a scene; leave "
                         "it out.");
    scenes::LoadOptions load_options;
    load_options.models_dir = models_dir;
    load_options.exact_poses = exact_pose;
    load_options.logs = pose_logs();
    if (!pose.empty()) {
        if (!poses.empty())
            throw InputError("--pose and --poses exclude each other; give one of them.");
        scenes::PoseRows rows{};
        std::copy_n(pose.begin(), rows.size(), rows.begin());
        const Pose p = scenes::pose_of(rows);
        if (!(p.translation.cwiseAbs().maxCoeff() <= max_coordinate))
            throw InputError(
                "--pose: its translation is not finite or beyond 1e70; move the "
                "bodies nearer to the origin.");
        load_options.pose = p;
    }
    return scenes::load_scene(names, load_options);
}

std::array<std::string, 2> SceneOptions::pose_logs() const {
    // Names of bodies come before A and B, as in --bodies.
    std::vector<std::string> known = {"A", "B"};
    if (names.size() == 2) {
        const std::array<std::string, 2> bodies = scenes::body_names(names[0], names[1]);
        known.insert(known.begin(), bodies.begin(), bodies.end());
    }
    // The place of the name, with "=", at the beginning of a text.
    const auto named_at = [&known](const std::string& text) {
        return static_cast<std::size_t>(
            std::ranges::find_if(
                known, [&](const std::string& name) { return text.starts_with(name + "="); }) -
            known.begin());
    };
    if (named_at(poses) == known.size()) return {"", poses};
    std::array<std::string, 2> logs;
    for (std::string rest = poses; !rest.empty();) {
        const std::size_t place = named_at(rest);
        std::string& log = logs[place % 2];
        if (!log.empty())
            throw InputError("--poses " + poses + ": " + known[place] +
                             " is named twice; give A=FILE,B=FILE.");
        rest.erase(0, known[place].size() + 1);
        std::size_t end = rest.find(',');
        while (end != rest.npos && named_at(rest.substr(end + 1)) == known.size())
            end = rest.find(',', end + 1);
        log = rest.substr(0, end);
        if (log.empty())
            throw InputError("--poses " + poses + ": the file of " + known[place] +
                             " has no name; give A=FILE,B=FILE.");
        rest = end == rest.npos ? "" : rest.substr(end + 1);
    }
    return logs;
}

bool SceneOptions::is_recording() const {
    return recorded || (!given && names.size() == 1 && scenes::names_recording(names[0]));
}

std::shared_ptr<const scenes::RecordingFile> SceneOptions::recording_file() const {
    return recorded ? recorded : std::make_shared<const scenes::RecordingFile>(names[0], selection);
}

bool SceneOptions::is_trace() const {
    return !given && names.size() == 1 && scenes::names_trace(names[0]);
}

std::string SceneOptions::file_stem(const std::string& scene) const {
    if (given || std::none_of(names.begin(), names.end(), scenes::names_recording)) return scene;
    std::string stems;
    for (const std::string& name : names)
        stems += (stems.empty() ? "" : "-") + std::filesystem::path(name).stem().string();
    std::string stem = scenes::file_name_of(stems);
    // Parts of their own, since a name that is too long is cut.
    if (!selection.name.empty()) stem += "_query-" + scenes::file_name_of(selection.name);
    if (!selection.tag.empty()) stem += "_tag-" + scenes::file_name_of(selection.tag);
    return stem;
}

std::vector<int> frames_of(const scenes::Scene& scene, const std::string& list) {
    return scene.listed.empty()
               ? parse_frames(list, scene.frames, scene.name)
               : frames_among(scene.listed, list, scene.file.string(), "it may have");
}

std::vector<int> parse_levels(const std::string& text, int deepest,
                              const std::vector<int>& automatic, const std::string& name) {
    const std::string option = name + " " + text;
    std::vector<int> levels;
    std::set<int> seen;
    const auto add = [&](int level) {
        if (seen.insert(level).second) levels.push_back(level);
    };
    const NumberRange range{option, "level", "this scene's hierarchies have", deepest,
                            "levels such as 5,7,9 or 0:12 or leaves"};
    for (const std::string& part : split_list(text, ',')) {
        if (part == "auto") {
            for (const int level : automatic) add(level);
            continue;
        }
        if (part == "all") {
            for (int level = 0; level <= deepest; ++level) add(level);
            continue;
        }
        if (part == "leaves") {
            add(leaf_level);
            continue;
        }
        for (const int level : parse_numbers(part, range)) add(level);
    }
    return levels;
}

int parse_level(const std::string& text, int deepest, const std::string& name) {
    const std::vector<int> levels = parse_levels(text, deepest, {}, name);
    if (levels.size() != 1)
        throw InputError(name + " " + text + ": this command takes one level; give one.");
    return levels[0];
}

int SceneOptions::frame_of(const scenes::Scene& scene) const {
    if (frames.empty()) return scene.default_frame;
    const std::vector<int> wanted = frames_of(scene, frames);
    if (wanted.size() != 1)
        throw InputError("--frames " + frames + ": this command takes one frame; give one.");
    return wanted[0];
}

std::vector<std::string> utf8_names(const std::vector<std::string>& names) {
    std::vector<std::string> result;
    for (const std::string& name : names) result.push_back(as_utf8(name));
    return result;
}

BuildOptions HierarchyOptions::build() const {
    BuildOptions options;
    options.fit.growth = growth;
    if (!(margin >= 0 && margin <= 1))
        throw InputError(format("--margin %g: give a share of the radius from 0 to 1.", margin));
    options.fit.margin = margin + 0.0;  // -0 is 0
    options.split = split;
    options.threads = processor_count();
    return options;
}

std::string volume_names(const char* separator) {
    std::string names;
    for (const VolumeKind kind : all_volume_kinds())
        names += (names.empty() ? "" : separator) + std::string(volume_kind_name(kind));
    return names;
}

std::vector<VolumeKind> HierarchyOptions::kinds() const {
    std::vector<VolumeKind> kinds;
    for (const std::string& name : split_list(volumes)) {
        const std::optional<VolumeKind> kind = volume_kind_of(name);
        if (!kind)
            throw InputError("--volume " + volumes + ": '" + name + "' is not a volume" +
                             did_you_mean(name, split_list(volume_names(","))) + "; give some of " +
                             volume_names(",") + ".");
        if (std::find(kinds.begin(), kinds.end(), *kind) == kinds.end()) kinds.push_back(*kind);
    }
    return kinds;
}

VolumeKind HierarchyOptions::kind() const {
    const std::vector<VolumeKind> all = kinds();
    if (all.size() != 1)
        throw InputError("--volume " + volumes + ": this command takes one of " +
                         volume_names(",") + " at a time.");
    return all[0];
}

std::vector<SplitMethod> splits_of(const std::string& list) {
    std::vector<SplitMethod> splits;
    for (const std::string& name : split_list(list)) {
        const std::optional<SplitMethod> split = split_method_of(name);
        if (!split)
            throw InputError("--split " + list + ": '" + name + "' is not a way to divide nodes" +
                             did_you_mean(name, {"paper", "cost"}) +
                             "; give paper, cost, or both.");
        if (std::find(splits.begin(), splits.end(), *split) == splits.end())
            splits.push_back(*split);
    }
    return splits;
}

void note_doubts(const HierarchyOptions& options, const std::vector<VolumeKind>& kinds,
                 const Note& note) {
    const HierarchyOptions usual;
    const bool asks_margin = options.margin != usual.margin,
               asks_growth = options.growth != usual.growth;
    const bool no_margin = asks_margin && std::none_of(kinds.begin(), kinds.end(), has_margin),
               no_growth = asks_growth && std::none_of(kinds.begin(), kinds.end(), has_growth);
    std::string volumes;
    for (const VolumeKind kind : kinds)
        volumes += (volumes.empty() ? "" : ", ") + std::string(volume_kind_name(kind));
    if (no_margin || no_growth)
        note("scb: " +
             std::string(no_margin && no_growth ? "--margin and --growth have"
                         : no_margin            ? "--margin has"
                                                : "--growth has") +
             " no effect on " + volumes + ".");
}

}  // namespace scb::app
