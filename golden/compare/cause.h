#pragma once

#include <filesystem>
#include <string>

#include "golden/suite/case_record.h"

namespace scb::golden {

/// Why a run may differ from its baseline, as far as their records tell: only what is certain.
struct Cause {
    std::string sentences;      ///< empty: none is known
    bool other_meshes = false;  ///< a body has another mesh than before
    bool has_settings = false;  ///< both say what was asked, so all that changed of it is named
};

/// What the case was made of before and is made of now: "The overlap test changed: symmetric
/// instead of corrected. The mesh of body A changed: 320 triangles instead of 1,280. Body B moved:
/// 0.02 along x, 1.5 degrees." Another command is quoted where nothing of this says what changed.
Cause cause_of(const CaseRecord& before, const CaseRecord& after);

}  // namespace scb::golden
