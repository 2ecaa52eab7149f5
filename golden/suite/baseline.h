#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden/suite/suite.h"

namespace scb::golden {

/// The files of a case: of its baseline in one folder, of a run in another.
struct CaseFiles {
    std::filesystem::path counts, ids, image, meta, trace;
    std::filesystem::path trace_1_0;  ///< a trace that scb 1.0 wrote
};
CaseFiles case_files(const std::filesystem::path& folder, const std::string& name);
/// The trace that exists; empty if there is none.
std::filesystem::path trace_of(const CaseFiles& files);

/// Throws InputError if the path of the baselines exists, but is not a folder, or its files cannot
/// be read: they would count as missing.
void check_readable(const std::filesystem::path& baselines);

/// The pictures that are accepted: NAME.png, and NAME.2.png, NAME.3.png, ... as long as the numbers
/// are consecutive.
std::vector<std::filesystem::path> accepted_images(const std::filesystem::path& folder,
                                                   const std::string& name);

/// The treatment of the trace of a baseline if the run has none.
enum class OldTrace { removed, kept };

/// Replaces the baseline by the files of a run, including its trace if there is one. Removes
/// further files of the baseline: ids or a picture if the case makes none any more, and all other
/// accepted pictures if the run's picture is not accepted. All or nothing, see replace_files.
/// Returns the names of the files that changed. Throws OutputError, InputError.
std::vector<std::string> replace_baseline(const std::filesystem::path& baselines,
                                          const std::filesystem::path& candidates,
                                          const std::string& name,
                                          OldTrace old_trace = OldTrace::removed);

/// Removes the remains of a killed update: files that were never put into place. Not while another
/// update may run, see BaselineLock.
void remove_unfinished(const std::filesystem::path& baselines);

/// Pictures of the suite's cases, NAME.3.png, that are never compared, since accepted_images ends
/// before them.
std::vector<std::string> uncompared_images(const std::filesystem::path& baselines,
                                           const Suite& suite);

/// Files in the folder of baselines that belong to no case of the suite.
std::vector<std::string> stray_files(const std::filesystem::path& baselines, const Suite& suite);

}  // namespace scb::golden
