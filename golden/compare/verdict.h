#pragma once

#include <optional>
#include <string_view>

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

/// "same", "different", "size differs", "missing baseline", "new output", "could not run",
/// "skipped".
std::string_view verdict_name(Verdict verdict);
std::optional<Verdict> verdict_of(std::string_view name);

/// Whether a run with such a case fails: all but same and skipped.
bool is_failure(Verdict verdict);

}  // namespace scb::golden
