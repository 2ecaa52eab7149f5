#pragma once

#include <filesystem>
#include <string>

#include "golden/suite/case_record.h"
#include "scb/pose.h"

namespace scb::golden {

/// Why a run may differ from its baseline, from their records: only certain causes.
struct Cause {
    std::string sentences;      ///< empty: no cause is known
    bool other_meshes = false;  ///< a body has another mesh than before
    bool has_settings = false;  ///< both records have settings, so every change of them is named
};

/// The changes of the case's inputs: "The overlap test changed: symmetric instead of corrected. The
/// mesh of body A changed: 320 triangles instead of 1,280. Body B moved: 0.02 along x, 1.5
/// degrees." The commands are quoted if they differ and nothing else changed.
Cause cause_of(const CaseRecord& before, const CaseRecord& after);

/// The motion of a body between two poses, as words behind its name: "moved: 0.02 along x, 1.5
/// degrees", "turned: 1.5 degrees"; empty if the poses are equal. Lengths are the motion of the
/// body's origin along the axes of the world. Parts below a millionth of the rest are rounding, and
/// are left out.
std::string motion_words(const Pose& before, const Pose& after);

}  // namespace scb::golden
