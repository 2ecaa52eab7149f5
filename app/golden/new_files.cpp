#include "app/golden/new_files.h"

#include <system_error>

#include "core/platform/output_file.h"
#include "scb/error.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;

/// Makes the folder and its missing parents; adds those that were made, the outermost first.
void make_folder(const fs::path& folder, std::vector<fs::path>& made) {
    if (folder.empty() || fs::is_directory(folder)) return;
    make_folder(folder.parent_path(), made);
    std::error_code error;
    if (fs::create_directory(folder, error)) made.push_back(folder);
    if (error)
        throw OutputError("Cannot make the folder \"" + folder.string() + "\": " + error.message() +
                          "; choose another place.");
}

}  // namespace

void refuse_taken(const std::vector<NewFile>& files) {
    for (const NewFile& file : files) {
        std::error_code ignored;
        for (fs::path folder = file.path.parent_path(); folder.has_relative_path();
             folder = folder.parent_path())
            if (fs::exists(fs::symlink_status(folder, ignored)) &&
                !fs::is_directory(folder, ignored))
                throw InputError(folder.string() +
                                 ": this is no folder, and one is to be made here for " +
                                 file.path.string() + "; name another with -o, or move it.");
        // Broken links are taken, too.
        if (fs::exists(fs::symlink_status(file.path, ignored)))
            throw InputError(file.path.string() +
                             ": this file exists, and nothing is overwritten; remove it, or name "
                             "another folder with -o or other files with --ci.");
    }
}

void write_new_files(const std::vector<NewFile>& files) {
    std::vector<fs::path> made;
    try {
        for (const NewFile& file : files) {
            make_folder(file.path.parent_path(), made);
            write_file_whole(file.path, file.text);
            made.push_back(file.path);
        }
    } catch (...) {
        std::error_code ignored;
        // Removes a folder only if nothing else has been put into it.
        for (auto place = made.rbegin(); place != made.rend(); ++place) fs::remove(*place, ignored);
        throw;
    }
}

}  // namespace scb::app
