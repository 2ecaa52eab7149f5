#include "app/pictures/folder_index.h"

#include <utility>

#include "render/files/output_file.h"
#include "scb/error.h"
#include "scenes/text/json_reader.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

// That of a million pictures.
constexpr std::size_t largest_index = std::size_t{1} << 30;

bool has_field(const Json& object, const char* name, Json::value_t type) {
    return object.contains(name) && object[name].type() == type;
}

/// Whether it is what a run of scb says of its pictures.
bool is_run(const Json& json) {
    if (!json.is_object() || !has_field(json, "command", Json::value_t::string) ||
        !has_field(json, "versions", Json::value_t::object) || !json["versions"].contains("scb") ||
        !has_field(json, "files", Json::value_t::array))
        return false;
    for (const Json& file : json["files"])
        if (!file.is_object() || !has_field(file, "file", Json::value_t::string)) return false;
    return true;
}

/// The runs of an index, the latest first; none where it is not one.
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

/// An index of runs, of which there are some.
Json index_of(const std::vector<Json>& runs) {
    Json index = runs.front();
    if (runs.size() > 1) index["earlier"] = std::vector<Json>(runs.begin() + 1, runs.end());
    return index;
}

}  // namespace

FolderIndex::FolderIndex(std::filesystem::path file) : file_(std::move(file)) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file_, ignored))
        throw InputError(file_.string() +
                         ": a folder has the name of the index of pictures; move it away, or name "
                         "another folder with -o.");
    if (!render::is_there(file_)) return;
    Json index = Json::parse(scenes::read_text_file(file_.string(), largest_index), nullptr, false);
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
    replaced_.insert(picture);
    bool changed = false;
    for (Run& run : runs_)
        if (run.on_disk && run.pictures.contains(picture)) {
            run.on_disk = false;
            changed = true;
        }
    if (changed) write_rest();
}

void FolderIndex::write_rest() const {
    std::vector<Json> rest;
    for (const Run& run : runs_)
        if (run.on_disk) rest.push_back(run.json);
    if (!rest.empty()) {
        render::write_file_whole(file_, index_text(index_of(rest)));
        return;
    }
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
}

void FolderIndex::write(const Json& run) {
    std::vector<Json> all = {run};
    for (const Run& earlier : runs_) {
        Json files = Json::array();
        for (const Json& entry : earlier.json["files"])
            if (!replaced_.contains(entry["file"].get<std::string>())) files.push_back(entry);
        if (files.empty()) continue;
        all.push_back(earlier.json);
        all.back()["files"] = std::move(files);
    }
    render::write_file_whole(file_, index_text(index_of(all)));
}

std::string index_text(const Json& index) {
    return index.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace scb::app
