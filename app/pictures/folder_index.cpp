#include "app/pictures/folder_index.h"

#include <sys/stat.h>

#include <algorithm>
#include <utility>

#include "core/platform/folder_lock.h"
#include "core/platform/json_reader.h"
#include "core/platform/output_file.h"
#include "scb/error.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

// The size of an index of a million pictures.
constexpr std::size_t largest_index = std::size_t{1} << 30;

bool has_field(const Json& object, const char* name, Json::value_t type) {
    return object.contains(name) && object[name].type() == type;
}

/// Whether the value describes a run of scb and its pictures.
bool is_run(const Json& json) {
    if (!json.is_object() || !has_field(json, "command", Json::value_t::string) ||
        !has_field(json, "versions", Json::value_t::object) || !json["versions"].contains("scb") ||
        !has_field(json, "files", Json::value_t::array))
        return false;
    for (const Json& file : json["files"])
        if (!file.is_object() || !has_field(file, "file", Json::value_t::string)) return false;
    return true;
}

/// The runs of an index, the latest first; none if the value is no index.
std::vector<Json> runs_of(Json index) {
    if (!is_run(index)) return {};
    std::vector<Json> runs;
    Json earlier = Json::array();
    if (index.contains("earlier")) {
        earlier = std::move(index["earlier"]);
        index.erase("earlier");
    }
    if (!earlier.is_array()) return {};
    runs.push_back(std::move(index));
    for (Json& run : earlier) {
        if (!is_run(run)) return {};
        runs.push_back(std::move(run));
    }
    return runs;
}

/// Whether runs have the same command and inputs, as far as both name them.
bool are_of_same_source(const Json& a, const Json& b) {
    for (const char* name : {"command", "source", "recording"})
        if (a.contains(name) && b.contains(name) && a[name] != b[name]) return false;
    return true;
}

}  // namespace

FolderIndex::FolderIndex(std::filesystem::path file) : file_(std::move(file)) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file_, ignored))
        throw InputError(file_.string() +
                         ": a folder has the name of the index of pictures; move it away, or name "
                         "another folder with -o.");
    read_if_changed();
}

FolderIndex::Version FolderIndex::version() const {
    struct stat status {};
    if (::stat(file_.c_str(), &status) != 0) return {};
    return {status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_size};
}

void FolderIndex::read_if_changed() {
    const Version now = version();
    if (now == read_) return;
    runs_.clear();
    read_ = now;
    if (!is_there(file_)) return;
    const std::string text = read_text_file(file_.string(), largest_index);
    Json index;
    try {
        index = parse_ordered_json(text, file_.string());
    } catch (const InputError&) {
        // Reported below, since there are no runs.
    }
    for (Json& json : runs_of(std::move(index))) {
        Run& run = runs_.emplace_back();
        for (const Json& entry : json["files"])
            run.pictures.insert(entry["file"].get<std::string>());
        run.json = std::move(json);
    }
    if (runs_.empty())
        throw InputError(file_.string() +
                         ": this is no index of pictures that scb wrote, or a damaged one; move it "
                         "away, or name another folder with -o.");
}

void FolderIndex::about_to_write(const std::string& picture) {
    const bool is_first = replaced_.insert(picture).second;
    if (is_first && is_there(file_.parent_path() / picture)) gone_.insert(picture);
    const FolderLock lock(file_.parent_path(), FolderLock::Busy::wait);
    read_if_changed();
    const std::size_t before = runs_.size();
    for (std::size_t i = before; i-- > 0;) {
        if (!runs_[i].pictures.contains(picture)) continue;
        const auto at = runs_.begin() + static_cast<std::ptrdiff_t>(i);
        std::size_t older = runs_.size() - 1 - i;
        const auto place = std::find_if(taken_.begin(), taken_.end(), [&older](TakenRun& other) {
            if (other.older > older) return true;
            ++older;
            return false;
        });
        taken_.insert(place, {std::move(*at), older});
        runs_.erase(at);
    }
    if (runs_.size() != before) write_runs();
}

void FolderIndex::write_runs() {
    if (runs_.empty()) {
        std::error_code ignored;
        std::filesystem::remove(file_, ignored);
    } else {
        Json index = runs_.front().json;
        for (std::size_t i = 1; i < runs_.size(); ++i) index["earlier"].push_back(runs_[i].json);
        write_file_whole(file_, index_text(index));
    }
    read_ = version();
}

std::size_t FolderIndex::write(const Json& run) {
    const FolderLock lock(file_.parent_path(), FolderLock::Busy::wait);
    read_if_changed();
    for (TakenRun& taken : taken_)
        runs_.insert(runs_.end() - static_cast<std::ptrdiff_t>(std::min(taken.older, runs_.size())),
                     std::move(taken.run));
    taken_.clear();
    std::size_t of_others = 0;
    for (Run& earlier : runs_) {
        const bool is_other = !are_of_same_source(earlier.json, run);
        Json files = Json::array();
        for (const Json& entry : earlier.json["files"]) {
            const std::string name = entry["file"];
            of_others += is_other && gone_.contains(name);
            if (!replaced_.contains(name) && is_there(file_.parent_path() / name))
                files.push_back(entry);
        }
        earlier.json["files"] = std::move(files);
    }
    std::erase_if(runs_, [](const Run& earlier) { return earlier.json["files"].empty(); });
    runs_.insert(runs_.begin(), {run, replaced_});
    write_runs();
    return of_others;
}

std::string index_text(const Json& index) {
    return index.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace scb::app
