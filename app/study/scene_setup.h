#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/study/mutation.h"
#include "scb/any_hierarchy.h"
#include "scb/level_cover.h"
#include "scenes/recordings/recording_summary.h"
#include "scenes/scene/load_scene.h"

namespace scb::app {

/// Receives a sentence for the user about an option that may surprise.
using Note = std::function<void(const std::string& line)>;

/// The names of a scene, and the frame or queries to choose from it.
struct SceneOptions {
    std::vector<std::string> names;
    std::vector<double> pose;
    std::string poses;        ///< logs of poses, see pose_logs
    bool exact_pose = false;  ///< poses must be rigid to 1e-9, see LoadOptions
    std::string models_dir;
    std::string frames;  ///< for commands that take frames here; empty: the scene's own
    scenes::QuerySelection selection{};  ///< of a recording's queries
    /// A scene in memory. Then the one name is only its title.
    std::shared_ptr<const scenes::Scene> given{};
    /// A recording in memory. Then the one name is only its title.
    std::shared_ptr<const scenes::RecordingFile> recorded{};

    /// Whether the one name is another engine's recording. As a scene it has the recorded meshes
    /// and poses.
    bool is_recording() const;
    /// Whether the one name is a trace.
    bool is_trace() const;
    /// The recording, in memory or from its file. Throws InputError.
    std::shared_ptr<const scenes::RecordingFile> recording_file() const;
    /// The logs in `poses`, of the first and the second mesh: "FILE" is of the second, "A=FILE" and
    /// "B=FILE" name the mesh, and a comma is between the two. In place of A and B, a body may have
    /// its name. Throws InputError.
    std::array<std::string, 2> pose_logs() const;
    /// The beginning of file names for a scene of this name. If a recording is among the names, it
    /// is the stems of the files, since a scene may have many recordings, and the selected queries;
    /// else the scene's name.
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

/// The levels in a list: "5,7,9,11", "0:12", "0:12:3", "leaves", "all", "auto" (the levels in
/// `automatic`), or a mixture; each once, in the order given. Throws InputError if the text is no
/// such list, or names a level below 0 or above `deepest`. `name`: the option's.
std::vector<int> parse_levels(const std::string& text, int deepest,
                              const std::vector<int>& automatic = {},
                              const std::string& name = "--levels");

/// The same for a command that takes one level. Throws InputError if the text names several.
int parse_level(const std::string& text, int deepest, const std::string& name = "--levels");

/// The names as UTF-8, for JSON and headers.
std::vector<std::string> utf8_names(const std::vector<std::string>& names);

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
                 const Note& note);

/// The names of all volumes.
std::string volume_names(const char* separator);

/// The splits in a list, each once; throws InputError for an unknown name.
std::vector<SplitMethod> splits_of(const std::string& list);

}  // namespace scb::app
