#pragma once

#include <memory>
#include <string>

#include "core/model/tree.h"
#include "scb/mesh.h"
#include "scb/pose.h"

namespace scb {

/// A body at a frame, with its hierarchy at that frame, by any builder.
struct BodyAtFrame {
    std::string name;
    std::shared_ptr<const Mesh> mesh;  ///< without triangles if the items are objects
    std::shared_ptr<const Tree> tree;
    Pose pose;
    std::uint32_t number = 0;  ///< the tree's number in a recording
};

}  // namespace scb
