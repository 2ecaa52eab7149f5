#pragma once

#include "core/base/enum_names.h"

namespace scb::golden {

/// What the comparison of a case with its baseline came to.
enum class Verdict {
    same,
    different,         ///< counts, ids or colors
    size_differs,      ///< the pictures cannot be compared pixel by pixel
    missing_baseline,  ///< there is none; the candidate is left to be looked at
    new_output,        ///< it makes something that the baseline does not have
    could_not_run,     ///< it failed, or a file of the baseline cannot be read
    skipped,           ///< what it needs (meshes) is not here
};

inline constexpr EnumNames<Verdict, 7> verdict_names = {
    "same",       "different",     "size differs", "missing baseline",
    "new output", "could not run", "skipped"};

/// Whether a run with such a case fails: all but same and skipped.
constexpr bool is_failure(Verdict verdict) {
    return verdict != Verdict::same && verdict != Verdict::skipped;
}

}  // namespace scb::golden
