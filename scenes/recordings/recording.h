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

/// Two bodies that were queried, and at which frames.
struct QueriedPair {
    std::array<std::uint32_t, 2> bodies{};  ///< numbers
    std::vector<int> frames;                ///< ascending
    /// The frame to show: the first with the most pairs, or, where none has any, tests.
    int fullest = 0;
    std::pair<std::size_t, std::size_t> most{};
};

/// A recording that was read through once: what there is in it.
struct Recording {
    std::shared_ptr<const RecordingFile> file;
    std::string engine;  ///< what made it; where that is not told, what its file is called
    /// Its meshes, bodies and poses: of meshes that change, the first. Bodies of trees without a
    /// mesh have one without triangles; where there are no bodies, the trees are. Its file is the
    /// recording.
    Scene scene;
    std::map<std::uint32_t, std::size_t> bodies;  ///< by their numbers, indices of Scene::bodies
    std::vector<QueriedPair> pairs;               ///< in the order of their first queries
    /// Why hierarchies of this project cannot be made of the scene, a sentence; empty: they can.
    std::string refusal;
    bool changes_meshes = false;  ///< that is why: of one frame they can, see scene_at
};

/// Throws InputError as RecordedQueries does, and where it has no tree.
Recording read_recording(std::shared_ptr<const RecordingFile> file);
Recording read_recording(const std::string& path);

/// The scene, for hierarchies of this project, which are of one mesh and need poses: of
/// meshes that change as they are at the one frame that `frames` names: the first where it is
/// empty, that with the most pairs of auto_frames. Throws InputError also where it names several
/// and a mesh changes, or a body has no pose.
Scene scene_of_recording(const std::string& path, const std::string& frames);
/// The scene with its meshes as they are at that frame, which is its default one.
Scene scene_at(const Recording& recording, int frame);

/// All of it finite, see MeshState. Where a tree has no mesh, its items are objects: one mesh
/// without triangles stands for all.
std::shared_ptr<const Mesh> mesh_of(const RecordedQueries& queries, std::uint32_t tree);
/// The same of a body, stretched as its pose says.
std::shared_ptr<const Mesh> mesh_of_body(RecordedQueries& queries, std::uint32_t body);

/// What a tree is called that no body has.
std::string name_of(const TreeState& tree, std::uint32_t number);

}  // namespace scb::scenes
