#include "app/query/output_guard.h"

#include <filesystem>

#include "core/platform/input_files.h"
#include "core/platform/output_file.h"
#include "scb/error.h"

namespace scb::app {
void check_output(const std::string& path, const std::string& option,
                  const std::string& folder_to_make) {
    if (path == "-") throw InputError(option + " -: standard output is taken; name a file.");
    std::error_code ignored;
    refuse_input(path, option);
    // Fail before the work, not after it.
    std::filesystem::path parent = std::filesystem::path(path).parent_path();
    if (parent.empty()) parent = ".";
    const auto folder_of = [](const std::filesystem::path& file) {
        std::error_code none;
        return std::filesystem::weakly_canonical(file, none).parent_path();
    };
    const bool will_be_made =
        !folder_to_make.empty() &&
        folder_of(std::filesystem::path(folder_to_make) / "file") == folder_of(parent / "file");
    if (!will_be_made && !std::filesystem::is_directory(parent, ignored))
        throw OutputError(option + " " + path + ": there is no folder " + parent.string() +
                          "; create it first.");
    if (std::filesystem::is_directory(path, ignored) || path.back() == '/')
        throw OutputError(option + " " + path + ": a folder has that name; name a file.");
}

void check_one_format(bool json, bool csv) {
    if (json && csv) throw InputError("--json and --csv exclude each other; give one of them.");
}

}  // namespace scb::app
