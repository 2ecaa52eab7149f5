#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/hierarchy/volume_tree.h"
#include "scenes/recordings/recording.h"

namespace scb::scenes {

/// A body at a frame, with the hierarchy that it has there, whoever built that.
struct BodyAtFrame {
    std::string name;
    std::shared_ptr<const Mesh> mesh;  ///< without triangles where items are objects
    std::shared_ptr<const VolumeTree> tree;
    Pose pose;
    std::uint32_t number = 0;  ///< of the tree, in a recording
};

/// Copies of bodies as they are at some step; trees that did not change are copied once.
class BodyCopies {
  public:
    BodyAtFrame copy(RecordedQueries& queries, const std::string& name, std::uint32_t tree,
                     const Pose& pose);
    /// The same of a body by its number. Throws InputError where its pose is not rigid.
    BodyAtFrame copy(RecordedQueries& queries, const Recording& recording, std::uint32_t body);
    /// "OBB", "AABB and hull": of all volumes that were copied.
    std::string volumes() const;

  private:
    /// By tree and what was told of it.
    std::map<std::pair<std::uint32_t, int>, std::shared_ptr<const VolumeTree>> trees_;
    std::vector<std::string> titles_;
};

/// All bodies of a recording at a frame.
struct RecordedBodies {
    int frame = 0;
    std::vector<BodyAtFrame> bodies;
    std::string volumes;  ///< see TraceEngine
};

/// Throws InputError where there is no tree yet, or a pose is not rigid.
RecordedBodies bodies_at(const Recording& recording, int frame);
/// At the one frame that the list names; where it is empty, at the first. Throws InputError.
RecordedBodies bodies_at(const Recording& recording, const std::string& frames);

}  // namespace scb::scenes
