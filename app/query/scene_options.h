#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/query/mutation.h"
#include "scb/any_hierarchy.h"
#include "scenes/recordings/recording_summary.h"
#include "scenes/scene/load_scene.h"

namespace scb::app {

/// Options of every command that takes a SCENE.
struct SceneOptions {
    std::vector<std::string> names;
    std::vector<double> pose;
    std::string models_dir;
    std::string frames;  ///< for commands that take frames here; empty: the scene's own
    scenes::QuerySelection selection{};  ///< of a recording's queries
    /// A scene in memory. Then the one name is only its title.
    std::shared_ptr<const scenes::Scene> given{};

    /// Whether the one name is another engine's recording. As a scene it has the recorded meshes
    /// and poses.
    bool is_recording() const;
    /// Whether the one name is a trace.
    bool is_trace() const;
    /// The beginning of file names for a scene of this name. If a recording is among the names, it
    /// is the stems of the files, since a scene may have many recordings; else the scene's name.
    std::string file_stem(const std::string& scene) const;
    /// `list_of_frames`: the frames that will be needed, as far as known: the meshes of a recording
    /// may change.
    scenes::Scene load(const std::string& list_of_frames = "") const;
    /// The frame given, or else the scene's own. Throws InputError if the scene has no such frame,
    /// or if several frames were given.
    int frame_of(const scenes::Scene& scene) const;
};

/// The frames of a scene in a list. Throws InputError.
std::vector<int> frames_of(const scenes::Scene& scene, const std::string& list);

/// The names as UTF-8, for JSON and headers.
std::vector<std::string> utf8_names(const std::vector<std::string>& names);

/// Names of built-in scenes, in the order of `scb scenes`.
std::vector<std::string> builtin_names();

void add_scene_options(const Command& command, SceneOptions& options, bool with_frame);

/// How hierarchies are built.
struct HierarchyOptions {
    std::string volumes = "scb";
    BallGrowth growth = BallGrowth::ritter;
    double margin = 0;
    SplitMethod split = SplitMethod::section_3;
    Mutation mutation = Mutation::none;

    /// Builds with as many threads as there are processors.
    BuildOptions build() const;
    /// The volumes given, each once; throws InputError for an unknown name.
    std::vector<VolumeKind> kinds() const;
    /// The one volume given; throws InputError if there are several.
    VolumeKind kind() const;
};
/// Notes the options without effect on any of the volumes.
void note_doubts(const HierarchyOptions& options, const std::vector<VolumeKind>& kinds,
                 const Console& console);
/// `several`: whether --volume takes a list. With `splits`, --split takes a list of names, which is
/// stored there instead of the one split.
void add_hierarchy_options(const Command& command, HierarchyOptions& options, bool several = true,
                           std::string* splits = nullptr);

/// The splits in a list, each once; throws InputError for an unknown name.
std::vector<SplitMethod> splits_of(const std::string& list);

}  // namespace scb::app
