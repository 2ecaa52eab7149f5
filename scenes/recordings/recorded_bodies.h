#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/model/tree.h"
#include "scenes/recordings/recording.h"

namespace scb::scenes {

/// A body at a frame, with the hierarchy that it has there, whoever built that.
struct BodyAtFrame {
    std::string name;
    std::shared_ptr<const Mesh> mesh;  ///< without triangles where items are objects
    std::shared_ptr<const Tree> tree;
    Pose pose;
    std::uint32_t number = 0;  ///< of the tree, in a recording
};

/// Copies of bodies as they are at some step; trees that did not change are copied once.
class BodyCopies {
  public:
    /// Of a tree that no body has.
    BodyAtFrame copy_tree(RecordedQueries& queries, const std::string& name, std::uint32_t tree);
    /// Of a body by its number, stretched as its pose says. Throws InputError where it has no pose.
    BodyAtFrame copy(RecordedQueries& queries, const Recording& recording, std::uint32_t body);
    /// "OBB", "AABB and hull": of all volumes that were copied.
    std::string volumes() const;

  private:
    std::shared_ptr<const Tree> tree_of(const EngineSide& side, std::uint32_t tree, int version,
                                        const Mat3& stretch);

    /// By tree, what was told of it, and the stretch.
    std::map<std::tuple<std::uint32_t, int, std::array<double, 9>>, std::shared_ptr<const Tree>>
        trees_;
    std::vector<std::string> titles_;
};

/// All bodies of a recording at a frame.
struct RecordedBodies {
    int frame = 0;
    std::vector<BodyAtFrame> bodies;
    std::string volumes;  ///< see TraceEngine
};

/// Throws InputError where there is no tree yet, or a body has no pose.
RecordedBodies bodies_at(const Recording& recording, int frame);
/// At the one frame that the list names; where it is empty, at the first. Throws InputError.
RecordedBodies bodies_at(const Recording& recording, const std::string& frames);

}  // namespace scb::scenes
