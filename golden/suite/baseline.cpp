#include "golden/suite/baseline.h"

#include <unistd.h>

#include <algorithm>
#include <map>
#include <set>
#include <system_error>

#include "core/platform/output_file.h"
#include "golden/suite/file_replacement.h"
#include "scb/error.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

std::string variant_name(const std::string& name, int variant) {
    return variant == 1 ? name + ".png" : name + "." + std::to_string(variant) + ".png";
}

/// The case that a file of a baseline is named after; empty if the file does not belong to a
/// baseline.
std::string case_of(std::string file) {
    for (const std::string_view ending :
         {".counts.json", ".meta.json", ".ids.png", ".trace.scbrec", ".scbtrace", ".png"})
        if (file.ends_with(ending)) {
            file.resize(file.size() - ending.size());
            if (ending != ".png") return file;
            // NAME.2.png
            const std::size_t point = file.rfind('.');
            const bool variant =
                point != std::string::npos && point + 1 < file.size() &&
                std::all_of(file.begin() + static_cast<std::ptrdiff_t>(point) + 1, file.end(),
                            [](char c) { return c >= '0' && c <= '9'; });
            return variant ? file.substr(0, point) : file;
        }
    return "";
}

}  // namespace

CaseFiles case_files(const fs::path& folder, const std::string& name) {
    return {folder / (name + ".counts.json"),  folder / (name + ".ids.png"),
            folder / (name + ".png"),          folder / (name + ".meta.json"),
            folder / (name + ".trace.scbrec"), folder / (name + ".scbtrace")};
}

fs::path trace_of(const CaseFiles& files) {
    if (is_there(files.trace)) return files.trace;
    return is_there(files.trace_1_0) ? files.trace_1_0 : fs::path();
}

void check_readable(const fs::path& baselines) {
    std::error_code error;
    const fs::file_status status = fs::status(baselines, error);
    if (status.type() == fs::file_type::not_found) return;
    if (!error && !fs::is_directory(status))
        throw InputError(
            baselines.string() +
            ": this is not a folder; name the folder of the baselines with --baselines.");
    if (error || ::access(baselines.c_str(), R_OK | X_OK) != 0)
        throw InputError(baselines.string() +
                         ": the baselines in this folder cannot be read; check its permissions.");
}

std::vector<fs::path> accepted_images(const fs::path& folder, const std::string& name) {
    std::vector<fs::path> images;
    for (int variant = 1;; ++variant) {
        const fs::path path = folder / variant_name(name, variant);
        if (!is_there(path)) return images;
        images.push_back(path);
    }
}

std::vector<std::string> replace_baseline(const fs::path& baselines, const fs::path& candidates,
                                          const std::string& name, OldTrace old_trace) {
    std::error_code error;
    fs::create_directories(baselines, error);
    if (error)
        throw OutputError(baselines.string() + ": this folder cannot be made (" + error.message() +
                          "); name another with --baselines.");
    const CaseFiles from = case_files(candidates, name), to = case_files(baselines, name);
    const std::vector<fs::path> accepted = accepted_images(baselines, name);
    const bool picture_is_accepted =
        std::any_of(accepted.begin(), accepted.end(),
                    [&](const fs::path& image) { return files_equal(from.image, image); });
    std::vector<std::pair<fs::path, fs::path>> changed;
    std::vector<fs::path> gone;
    for (const auto member : {&CaseFiles::counts, &CaseFiles::ids, &CaseFiles::image,
                              &CaseFiles::meta, &CaseFiles::trace, &CaseFiles::trace_1_0}) {
        const bool kept = (member == &CaseFiles::trace || member == &CaseFiles::trace_1_0) &&
                          old_trace == OldTrace::kept;
        const bool same = member == &CaseFiles::image && picture_is_accepted;
        if (!is_there(from.*member)) {
            if (is_there(to.*member) && !kept) gone.push_back(to.*member);
        } else if (!same && !files_equal(from.*member, to.*member)) {
            changed.emplace_back(from.*member, to.*member);
        }
    }
    if (!picture_is_accepted)
        for (std::size_t i = 1; i < accepted.size(); ++i) gone.push_back(accepted[i]);
    std::vector<std::string> names;
    if (changed.empty() && gone.empty()) return names;
    replace_files(baselines, changed, gone);
    for (const auto& [source, target] : changed) names.push_back(target.filename().string());
    for (const fs::path& target : gone) names.push_back(target.filename().string() + " (removed)");
    return names;
}

void remove_unfinished(const fs::path& baselines) {
    std::error_code ignored;
    std::vector<fs::path> left;
    for (const fs::directory_entry& entry : fs::directory_iterator(baselines, ignored))
        if (entry.path().filename().string().starts_with(replacement_prefix)) left.push_back(entry);
    for (const fs::path& path : left) fs::remove_all(path, ignored);
}

std::vector<std::string> uncompared_images(const fs::path& baselines, const Suite& suite) {
    std::map<std::string, std::vector<fs::path>> accepted;
    for (const GoldenCase& golden : suite.cases)
        accepted[golden.name] = accepted_images(baselines, golden.name);
    std::vector<std::string> uncompared;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(baselines, ignored)) {
        const std::string file = entry.path().filename().string();
        const auto of_case = accepted.find(case_of(file));
        const bool is_variant = of_case != accepted.end() && file.ends_with(".png") &&
                                file != of_case->first + ".png" &&
                                file != of_case->first + ".ids.png";
        if (!is_variant) continue;
        const std::vector<fs::path>& images = of_case->second;
        if (std::find(images.begin(), images.end(), entry.path()) == images.end())
            uncompared.push_back(file);
    }
    std::sort(uncompared.begin(), uncompared.end());
    return uncompared;
}

std::vector<std::string> stray_files(const fs::path& baselines, const Suite& suite) {
    std::set<std::string> names;
    for (const GoldenCase& golden : suite.cases) names.insert(golden.name);
    std::vector<std::string> strays;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(baselines, ignored)) {
        const std::string file = entry.path().filename().string();
        const std::string name = case_of(file);
        if (!file.starts_with(".") && !name.empty() && !names.contains(name))
            strays.push_back(file);
    }
    std::sort(strays.begin(), strays.end());
    return strays;
}

}  // namespace scb::golden
