#pragma once

#include <filesystem>

#include "scenes/scene/motion.h"

namespace scb::scenes {

/// Reads the poses of bodies from text files, one row per frame. All logs of a scene have as many
/// rows.
///
/// A row has twelve numbers, [R|t] row by row, or `tx ty tz qx qy qz qw` with an optional time
/// stamp before, which is passed over. This is the trajectory format of the TUM RGB-D benchmark
/// (Sturm et al., "A Benchmark for the Evaluation of RGB-D SLAM Systems", 2012). Blanks, commas or
/// semicolons separate the numbers. Lines that begin with # are comments, and a first row without
/// any number is a header.
class PoseLogs {
  public:
    /// `exact`: refuses poses that are not rigid to 1e-9, see check_rigid. Else the nearest
    /// rotation is taken, see nearest_rigid; a quaternion is scaled to a unit one if its squared
    /// length differs from 1 by at most 1e-3.
    explicit PoseLogs(bool exact) : exact_(exact) {}

    /// Throws InputError, naming file and line: a row of other numbers, or of another count of
    /// numbers than the row before; a pose that is not rigid; no rows, more than most_frames, or
    /// not as many as the log before has.
    Motion read(const std::filesystem::path& file);

    /// The number of rows of each log; 0: there are no logs.
    int frames() const { return frames_; }
    /// The first log that was read.
    const std::filesystem::path& first() const { return first_; }

  private:
    bool exact_;
    int frames_ = 0;
    std::filesystem::path first_;
};

}  // namespace scb::scenes
