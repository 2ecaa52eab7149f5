#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scenes/recordings/recorded_queries.h"
#include "scenes/scene/scene.h"

namespace scb::scenes {

/// Two bodies of queries, and the frames of these queries.
struct QueriedPair {
    std::array<std::uint32_t, 2> bodies{};  ///< numbers
    std::vector<int> frames;                ///< ascending
    /// The frame to show: the first with the most pairs or, if there are no pairs, tests.
    int fullest = 0;
    std::pair<std::size_t, std::size_t> most{};
};

/// The contents of a recording.
struct Recording {
    std::shared_ptr<const RecordingFile> file;
    std::string engine;  ///< the engine's name, or else the name of the file
    /// The meshes, bodies and poses. A mesh that changes is in its first state. A body whose tree
    /// has no mesh has a mesh without triangles. Without bodies, each tree becomes a body. The
    /// scene's file is the recording.
    Scene scene;
    std::map<std::uint32_t, std::size_t> bodies;  ///< by their numbers, indices of Scene::bodies
    std::vector<QueriedPair> pairs;               ///< in the order of their first queries
    /// Why this project cannot build hierarchies of the scene, as a sentence; empty: it can.
    std::string refusal;
    /// The reason is a changed mesh: single frames are possible, see scene_at.
    bool changes_meshes = false;
};

/// Throws InputError as RecordedQueries does, and if there is no tree.
Recording read_recording(std::shared_ptr<const RecordingFile> file);
Recording read_recording(const std::string& path, const QuerySelection& selection = {});

/// The pair of bodies with these names, "A,B", or the only pair if `bodies` is empty. Throws
/// InputError if several pairs or none are left.
const QueriedPair& chosen_pair(const Recording& recording, const std::string& bodies);

/// The scene for hierarchies of this project, which need one mesh and poses. If meshes change, they
/// are taken at the one frame that `frames` names: the first frame if it is empty, the frame with
/// the most pairs for auto_frames. A body's pose in a frame is its pose at its first selected
/// query. Throws InputError also if it names several frames and a mesh changes, or if a pose is
/// unusable.
Scene scene_of_recording(const std::string& path, const std::string& frames,
                         const QuerySelection& selection = {});
/// The scene with its meshes at that frame, which becomes the default frame.
Scene scene_at(const Recording& recording, int frame);

/// The finite mesh of a tree, see MeshState. Trees without a mesh, whose items are objects, share
/// one mesh without triangles.
std::shared_ptr<const Mesh> mesh_of(const RecordedQueries& queries, std::uint32_t tree);
/// The same for a body, stretched by its pose.
std::shared_ptr<const Mesh> mesh_of_body(RecordedQueries& queries, std::uint32_t body);

/// The name of a tree without a body.
std::string name_of(const TreeState& tree, std::uint32_t number);

}  // namespace scb::scenes
