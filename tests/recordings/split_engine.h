#pragma once

#include <string>

namespace scb {

/// What is wrong with the engine of split triangles, on purpose.
enum class SplitBug {
    none,
    part_forgotten,  ///< of a triangle that is cut, the child with the larger coordinates gets none
    box_of_corners,  ///< a child's box has the mesh's corners on its side, not the corners of the
                     ///< cut
};

/// An engine with spatial splits: a node is cut at the middle of its longest side, triangles that
/// lie on both sides are cut and go to both children, whose boxes are of the parts. It makes one
/// query of two fans of long triangles, tests each pair of triangles once, and records it.
void record_split_engine(SplitBug bug, const std::string& path);

}  // namespace scb
