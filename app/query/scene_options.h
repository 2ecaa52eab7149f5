#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/query/mutation.h"
#include "scb/any_hierarchy.h"
#include "scenes/scene/load_scene.h"

namespace scb::app {

/// What every command that takes a SCENE understands.
struct SceneOptions {
    std::vector<std::string> names;
    std::vector<double> pose;
    std::string models_dir;
    std::string frames;  ///< of commands that take one; empty: the scene's own
    /// A scene that is there already: then the one name is nothing but what it is called.
    std::shared_ptr<const scenes::Scene> given{};

    /// Whether the one name is that of another engine's recording. As a scene it has the meshes and
    /// poses that were recorded.
    bool is_recording() const;
    /// Whether the one name is that of a trace.
    bool is_trace() const;
    /// What the names of files begin with that are made of the scene of this name: where there is a
    /// recording, of which there may be many of one scene, the stems of the files; else that name.
    std::string file_stem(const std::string& scene) const;
    /// `frames`: a list of those that will be asked for, as far as it is known: the meshes of a
    /// recording may change.
    scenes::Scene load(const std::string& list_of_frames = "") const;
    /// The one frame asked for, or the scene's own. Throws InputError where the scene has no such
    /// frame, or where several were asked for.
    int frame_of(const scenes::Scene& scene) const;
};

/// The frames of a scene that a list names. Throws InputError.
std::vector<int> frames_of(const scenes::Scene& scene, const std::string& list);

/// The names as UTF-8, for JSON and headers.
std::vector<std::string> utf8_names(const std::vector<std::string>& names);

/// Of built-in scenes, in the order of `scb scenes`.
std::vector<std::string> builtin_names();

void add_scene_options(const Command& command, SceneOptions& options, bool with_frame);

/// How hierarchies are built.
struct HierarchyOptions {
    std::string volumes = "scb";
    BallGrowth growth = BallGrowth::ritter;
    double margin = 0;
    SplitMethod split = SplitMethod::section_3;
    Mutation mutation = Mutation::none;

    /// In as many threads as there are processors.
    BuildOptions build() const;
    /// The volumes asked for, each once; throws InputError for an unknown name.
    std::vector<VolumeKind> kinds() const;
    /// The one volume asked for; throws InputError where there are several.
    VolumeKind kind() const;
};
/// Says which options have no effect on any of the volumes.
void note_doubts(const HierarchyOptions& options, const std::vector<VolumeKind>& kinds,
                 const Console& console);
/// `several`: whether --volume takes a list. Where there are `splits`, a list of names, --split
/// takes one and sets them instead of the one split.
void add_hierarchy_options(const Command& command, HierarchyOptions& options, bool several = true,
                           std::string* splits = nullptr);

/// The splits named in a list, each once; throws InputError for an unknown name.
std::vector<SplitMethod> splits_of(const std::string& list);

}  // namespace scb::app
