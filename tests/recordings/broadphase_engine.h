#pragma once

#include <string>

namespace scb {

/// What is wrong with the broadphase, on purpose.
enum class BroadphaseBug {
    none,
    leaf_not_updated,  ///< from frame 2 on, the leaf of object 5 keeps its box
    pair_order,        ///< a pair is reported where the first object has the lower number, and else
                       ///< not
};

/// A broadphase of moving boxes, which are objects without triangles: in each of four frames it
/// builds a tree of their boxes, tests the tree against itself, and records that. `extents`: the
/// objects' own boxes are recorded.
void record_broadphase(BroadphaseBug bug, bool extents, const std::string& path);

}  // namespace scb
