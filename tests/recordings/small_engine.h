#pragma once

#include <string>
#include <vector>

namespace scb {

/// What is wrong with the small engine, on purpose.
enum class Bug {
    none,
    box_not_refitted,  ///< a node keeps the box of the frame before
    child_dropped,     ///< a node forgets one of its children
    axis_flipped,      ///< the test adds where it must subtract, along y
    margin_negative,   ///< boxes must overlap by more than a length
    pose_transposed,   ///< rotations are read column by column
    pose_of_the_frame_before,
    wrong_triangle,  ///< a leaf holds the triangle of its neighbour
    wrong_radius,    ///< the test of balls adds A's radius twice
    early_exit,      ///< the last pair of nodes on the stack is left there
    visited_twice,   ///< the first child is pushed twice
};
inline constexpr const char* bug_names[] = {"none",
                                            "box-not-refitted",
                                            "child-dropped",
                                            "axis-flipped",
                                            "margin-negative",
                                            "pose-transposed",
                                            "pose-of-the-frame-before",
                                            "wrong-triangle",
                                            "wrong-radius",
                                            "early-exit",
                                            "visited-twice"};
inline constexpr int bug_count = 11;

/// An engine of some 150 lines, with hierarchies of boxes (of balls for `wrong_radius`), makes the
/// queries of two waving sheets in four frames, and records them.
void record_small_engine(Bug bug, const std::string& path);

}  // namespace scb
