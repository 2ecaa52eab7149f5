#pragma once

#include <string>
#include <vector>

#include "app/golden/new_files.h"
#include "core/base/enum_names.h"

namespace scb::app {

/// For which continuous integration files are written.
enum class InitCi { github, gitlab, both, none };

inline constexpr EnumNames<InitCi, 4> init_ci_names = {"github", "gitlab", "both", "none"};

/// Stands for the repository of scb where none is told.
inline constexpr const char* some_repository = "YOUR/COPY-OF-SCB";

/// The files that have a suite checked, from the folder where the program runs, which is the root
/// of the repository. `suite`: its path from there, of characters that need no quotes.
/// `repository`: that of scb on GitHub, OWNER/NAME.
std::vector<NewFile> workflow_files(InitCi ci, const std::string& suite,
                                    const std::string& repository);

/// Where jobs of GitLab go if .gitlab-ci.yml is there already, which must then include them.
inline constexpr const char* gitlab_included = ".gitlab/scb-golden.yml";

}  // namespace scb::app
