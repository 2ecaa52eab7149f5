#pragma once

#include <string>
#include <vector>

#include "app/golden/new_files.h"
#include "core/base/enum_names.h"

namespace scb::app {

/// The continuous integration services to write files for.
enum class InitCi { github, gitlab, both, none };

inline constexpr EnumNames<InitCi, 4> init_ci_names = {"github", "gitlab", "both", "none"};

/// Placeholder if no repository of scb is given.
inline constexpr const char* some_repository = "YOUR/COPY-OF-SCB";

/// The CI files that check a suite. The working folder is the root of the repository. `suite`: its
/// path from there, of characters that need no quotes. `repository`: of scb on GitHub, OWNER/NAME.
std::vector<NewFile> workflow_files(InitCi ci, const std::string& suite,
                                    const std::string& repository);

/// The file of GitLab jobs if .gitlab-ci.yml exists already; that file must then include this one.
inline constexpr const char* gitlab_included = ".gitlab/scb-golden.yml";

}  // namespace scb::app
