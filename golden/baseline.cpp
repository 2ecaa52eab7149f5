#include "golden/baseline.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <set>
#include <system_error>

#include "core/error.h"
#include "golden/files_equal.h"
#include "render/output_file.h"
#include "scenes/file_bytes.h"

namespace scb {
namespace {

namespace fs = std::filesystem;

const std::string staging_start = ".update-";

std::string variant_name(const std::string& name, int variant) {
    return variant == 1 ? name + ".png" : name + "." + std::to_string(variant) + ".png";
}

/// The case that a file of a baseline is named after; empty where it is none.
std::string case_of(std::string file) {
    for (const std::string_view ending :
         {".counts.json", ".meta.json", ".ids.png", ".scbtrace", ".png"})
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

/// A folder beside the files that it is to replace, which is gone at the end.
class StagingFolder {
  public:
    explicit StagingFolder(const fs::path& beside) {
        std::string name = (beside / (staging_start + "XXXXXX")).string();
        if (::mkdtemp(name.data()) == nullptr)
            throw OutputError("Cannot write into \"" + beside.string() +
                              "\": " + std::strerror(errno) +
                              "; choose a folder that may be written, with room.");
        path_ = name;
    }
    ~StagingFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    StagingFolder(const StagingFolder&) = delete;
    StagingFolder& operator=(const StagingFolder&) = delete;

    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

}  // namespace

CaseFiles case_files(const fs::path& folder, const std::string& name) {
    return {folder / (name + ".counts.json"), folder / (name + ".ids.png"),
            folder / (name + ".png"), folder / (name + ".meta.json"),
            folder / (name + ".scbtrace")};
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
                                          const std::string& name) {
    std::error_code error;
    fs::create_directories(baselines, error);
    if (error)
        throw OutputError(baselines.string() + ": this folder cannot be made (" + error.message() +
                          "); name another with --baselines.");
    const CaseFiles from = case_files(candidates, name), to = case_files(baselines, name);
    std::vector<std::pair<fs::path, fs::path>> changed;
    std::vector<fs::path> gone = accepted_images(baselines, name);
    if (!gone.empty()) gone.erase(gone.begin());
    for (const auto member : {&CaseFiles::counts, &CaseFiles::ids, &CaseFiles::image,
                              &CaseFiles::meta, &CaseFiles::trace}) {
        if (!is_there(from.*member)) {
            if (is_there(to.*member)) gone.push_back(to.*member);
        } else if (!is_there(to.*member) || !files_equal(from.*member, to.*member)) {
            changed.emplace_back(from.*member, to.*member);
        }
    }
    std::vector<std::string> names;
    {
        const StagingFolder staging(baselines);
        for (const auto& [source, target] : changed)
            write_file_whole(staging.path() / target.filename(), file_bytes(source.string()));
        for (const auto& [source, target] : changed) {
            fs::rename(staging.path() / target.filename(), target, error);
            if (error)
                throw OutputError(target.string() + ": it cannot be replaced (" + error.message() +
                                  "); see that it may be written.");
            names.push_back(target.filename().string());
        }
    }
    for (const fs::path& path : gone) {
        fs::remove(path, error);
        names.push_back(path.filename().string() + " (removed)");
    }
    return names;
}

void remove_unfinished(const fs::path& baselines) {
    std::error_code ignored;
    std::vector<fs::path> left;
    for (const fs::directory_entry& entry : fs::directory_iterator(baselines, ignored))
        if (entry.path().filename().string().starts_with(staging_start)) left.push_back(entry);
    for (const fs::path& path : left) fs::remove_all(path, ignored);
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

}  // namespace scb
