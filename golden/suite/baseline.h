#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden/suite/suite.h"

namespace scb::golden {

/// The files of a case: of its baseline in one folder, of what a run made in another.
struct CaseFiles {
    std::filesystem::path counts, ids, image, meta, trace;
};
CaseFiles case_files(const std::filesystem::path& folder, const std::string& name);

/// Throws InputError where the folder of baselines is there, but is not a folder or one whose files
/// cannot be read: they would count as missing.
void check_readable(const std::filesystem::path& baselines);

/// The pictures that are accepted: NAME.png, and NAME.2.png, NAME.3.png, ... as far as they follow
/// each other.
std::vector<std::filesystem::path> accepted_images(const std::filesystem::path& folder,
                                                   const std::string& name);

/// What becomes of the trace of a baseline where the run has none.
enum class OldTrace { removed, kept };

/// Puts what a run made in the place of the baseline, its trace included where there is one, and
/// removes what the baseline had beyond that: ids or a picture of a case that makes none any more;
/// and, where the run's picture is none of those that are accepted, the others of these. All or
/// nothing, see replace_files. Returns the names of the files that changed. Throws OutputError,
/// InputError.
std::vector<std::string> replace_baseline(const std::filesystem::path& baselines,
                                          const std::filesystem::path& candidates,
                                          const std::string& name,
                                          OldTrace old_trace = OldTrace::removed);

/// Removes what an update that was killed has left: files that never came to their places. Not
/// while another update may run, see BaselineLock.
void remove_unfinished(const std::filesystem::path& baselines);

/// Pictures of the suite's cases, NAME.3.png, that are never compared, since accepted_images ends
/// before them.
std::vector<std::string> uncompared_images(const std::filesystem::path& baselines,
                                           const Suite& suite);

/// Files in the folder of baselines that belong to no case of the suite.
std::vector<std::string> stray_files(const std::filesystem::path& baselines, const Suite& suite);

}  // namespace scb::golden
