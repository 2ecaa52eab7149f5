#include "core/platform/input_files.h"

#include <sys/stat.h>

#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "core/base/text_format.h"
#include "scb/error.h"

namespace scb {
namespace {

/// The identity of a file, under any name.
using Identity = std::pair<dev_t, ino_t>;

std::optional<struct stat> status_of(const std::filesystem::path& file) {
    struct stat status {};
    if (file.empty() || ::stat(file.c_str(), &status) != 0) return std::nullopt;
    return status;
}

std::optional<Identity> identity_of(const std::filesystem::path& file) {
    const auto status = status_of(file);
    if (!status) return std::nullopt;
    return Identity(status->st_dev, status->st_ino);
}

/// A text that changes when a file is written or replaced.
std::string version_of(const std::filesystem::path& file) {
    const auto status = status_of(file);
    if (!status) return "";
    return sentence(status->st_dev, ' ', status->st_ino, ' ', status->st_size, ' ',
                    status->st_mtim.tv_sec, ' ', status->st_mtim.tv_nsec);
}

struct InputFiles {
    std::mutex mutex;
    std::set<Identity> noted;
    std::map<std::filesystem::path, std::string> versions;  ///< of regular files, at their first
                                                            ///< note
    std::string last;
};

InputFiles& input_files() {
    static InputFiles files;
    return files;
}

}  // namespace

void note_input(const std::filesystem::path& file) {
    const auto identity = identity_of(file);
    if (!identity) return;
    InputFiles& files = input_files();
    const std::lock_guard lock(files.mutex);
    files.noted.insert(*identity);
    files.last = file.string();
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored))
        files.versions.try_emplace(std::filesystem::absolute(file, ignored), version_of(file));
}

void forget_inputs() {
    InputFiles& files = input_files();
    const std::lock_guard lock(files.mutex);
    files.noted.clear();
    files.versions.clear();
    files.last.clear();
}

const char* last_input() noexcept { return input_files().last.c_str(); }

std::map<std::filesystem::path, std::string> input_versions() {
    InputFiles& files = input_files();
    const std::lock_guard lock(files.mutex);
    return files.versions;
}

std::map<std::filesystem::path, std::string> present_versions(
    const std::map<std::filesystem::path, std::string>& files) {
    std::map<std::filesystem::path, std::string> now;
    for (const auto& [path, version] : files) now.emplace(path, version_of(path));
    return now;
}

std::string noted_inputs() {
    InputFiles& files = input_files();
    const std::lock_guard lock(files.mutex);
    std::string text;
    for (const auto& [device, number] : files.noted)
        text += std::to_string(device) + " " + std::to_string(number) + "\n";
    return text;
}

void note_inputs(std::string_view noted) {
    InputFiles& files = input_files();
    const std::lock_guard lock(files.mutex);
    std::istringstream text{std::string(noted)};
    text.imbue(std::locale::classic());
    for (Identity file; text >> file.first >> file.second;) files.noted.insert(file);
}

void refuse_input(const std::filesystem::path& output, const std::string& option) {
    const auto identity = identity_of(output);
    if (!identity) return;
    InputFiles& files = input_files();
    const std::lock_guard lock(files.mutex);
    if (files.noted.contains(*identity))
        throw InputError(option + " would replace " + output.string() +
                         ", which this command reads; name another place.");
}

}  // namespace scb
