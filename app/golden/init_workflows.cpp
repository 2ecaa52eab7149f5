#include "app/golden/init_workflows.h"

#include <kainjow/mustache.hpp>
#include <string_view>

#include "render/gl/embedded.h"

SCB_DECLARE_EMBEDDED(golden_github_yml)
SCB_DECLARE_EMBEDDED(golden_gitlab_yml)

namespace scb::app {
namespace {

namespace fs = std::filesystem;

std::string filled(std::string_view file, const std::string& suite, const std::string& repository) {
    kainjow::mustache::data values;
    values["suite"] = suite;
    values["repository"] = repository;
    values["version"] = SCB_VERSION;
    kainjow::mustache::mustache text{std::string(file)};
    return text.render(values);
}

}  // namespace

std::vector<NewFile> workflow_files(InitCi ci, const std::string& suite,
                                    const std::string& repository) {
    std::vector<NewFile> files;
    if (ci == InitCi::github || ci == InitCi::both)
        files.push_back({".github/workflows/scb-golden.yml",
                         filled(SCB_EMBEDDED(golden_github_yml), suite, repository)});
    if (ci == InitCi::gitlab || ci == InitCi::both) {
        std::error_code ignored;
        const bool taken = fs::exists(fs::symlink_status(".gitlab-ci.yml", ignored));
        files.push_back({taken ? gitlab_included : ".gitlab-ci.yml",
                         filled(SCB_EMBEDDED(golden_gitlab_yml), suite, repository)});
    }
    return files;
}

}  // namespace scb::app
