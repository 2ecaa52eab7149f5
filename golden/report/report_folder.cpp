#include "golden/report/report_folder.h"

#include <nlohmann/json.hpp>

#include "golden/report/html_report.h"
#include "render/files/output_file.h"
#include "scb/error.h"
#include "scenes/text/file_bytes.h"
#include "scenes/text/input_files.h"
#include "scenes/text/json_reader.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

/// The path of a file of the report. Refuses a pipe, which would wait for a reader.
fs::path place_of(const fs::path& folder, const fs::path& name) {
    const fs::path place = folder / name;
    scenes::refuse_input(place, "--report " + folder.string());
    std::error_code ignored;
    if (fs::exists(place, ignored) && !render::is_there(place))
        throw render::OutputError(
            place.string() +
            ": there is something of that name that is not a file; remove it, or name "
            "another folder with --report.");
    return place;
}

void clear_report(const fs::path& folder) {
    const std::string list = (folder / "results.json").string();
    std::error_code ignored;
    if (!fs::exists(list, ignored)) return;
    SuiteResult old;
    try {
        old = result_of(
            scenes::parse_json(scenes::read_text_file(list, std::size_t{1} << 30), list), list);
    } catch (const InputError&) {
        return;  // it is not a list of a report's files
    }
    for (const CaseResult& c : old.cases)
        for (const std::string& name : files_of(c))
            if (fs::path(name).filename() == name) fs::remove(place_of(folder, name), ignored);
    fs::remove(folder / "report.html", ignored);
    fs::remove(list, ignored);
}

}  // namespace

void write_report_folder(const SuiteResult& result, const fs::path& folder, const fs::path& work) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw render::OutputError(folder.string() + ": this folder cannot be made (" +
                                  error.message() + "); name another with --report.");
    clear_report(folder);
    for (const fs::directory_entry& entry : fs::directory_iterator(work))
        render::write_file_whole(place_of(folder, entry.path().filename()),
                                 scenes::file_bytes(entry.path().string()));
    render::write_file_whole(place_of(folder, "report.html"), report_html(result, work));
    render::write_file_whole(place_of(folder, "results.json"), results_json(result));
}

std::string results_json(const SuiteResult& result) {
    using Json = nlohmann::ordered_json;
    return result_json(result).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace scb::golden
