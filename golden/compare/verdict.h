#pragma once

#include "core/base/enum_names.h"

namespace scb::golden {

/// The result of the comparison of a case with its baseline.
enum class Verdict {
    same,
    different,         ///< counts, ids or colors
    size_differs,      ///< the pictures cannot be compared pixel by pixel
    missing_baseline,  ///< there is none; the candidate is kept to look at
    new_output,        ///< it makes an output that the baseline does not have
    could_not_run,     ///< it failed, or a file of the baseline cannot be read
    skipped,           ///< its meshes are not here
};

inline constexpr EnumNames<Verdict, 7> verdict_names = {
    "same",       "different",     "size differs", "missing baseline",
    "new output", "could not run", "skipped"};

/// Whether a run with such a case fails: all verdicts except same and skipped.
constexpr bool is_failure(Verdict verdict) {
    return verdict != Verdict::same && verdict != Verdict::skipped;
}

}  // namespace scb::golden
