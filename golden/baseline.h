#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden/suite.h"

namespace scb {

/// The files of a case: of its baseline in one folder, of what a run made in another.
struct CaseFiles {
    std::filesystem::path counts, ids, image, meta, trace;
};
CaseFiles case_files(const std::filesystem::path& folder, const std::string& name);

/// The pictures that are accepted: NAME.png, and NAME.2.png, NAME.3.png, ... as far as they follow
/// each other.
std::vector<std::filesystem::path> accepted_images(const std::filesystem::path& folder,
                                                   const std::string& name);

/// Puts what a run made in the place of the baseline, its trace included where there is one, and
/// removes what the baseline had beyond that (other accepted pictures; ids or a picture of a case
/// that makes none any more). Each file is written beside its place first and then put there, and
/// not one is put there before all are written: where that fails, the old baseline stays. Returns
/// the names of the files that changed. Throws OutputError, InputError.
std::vector<std::string> replace_baseline(const std::filesystem::path& baselines,
                                          const std::filesystem::path& candidates,
                                          const std::string& name);

/// Removes what an update that was killed has left: files that never came to their places.
void remove_unfinished(const std::filesystem::path& baselines);

/// Files in the folder of baselines that belong to no case of the suite.
std::vector<std::string> stray_files(const std::filesystem::path& baselines, const Suite& suite);

}  // namespace scb
