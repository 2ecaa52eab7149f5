#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace scb::app {

/// The index.json of a folder of pictures: the run that wrote it, and under `earlier` those before
/// it, the latest first, each with the pictures that no later run has replaced. At no time does the
/// file describe a picture that is not the one in the folder.
class FolderIndex {
  public:
    /// Reads the file where there is one. Throws InputError where that is none that scb wrote.
    explicit FolderIndex(std::filesystem::path file);

    /// To be called before a picture is replaced: takes the run that drew it out of the file, until
    /// write() puts back what is left of it.
    void about_to_write(const std::string& picture);

    /// Writes the file; `run` has the field `files`. Throws OutputError.
    void write(const nlohmann::ordered_json& run);

  private:
    struct Run {
        nlohmann::ordered_json json;
        std::set<std::string> pictures;
        bool on_disk = true;
    };
    void write_rest() const;

    std::filesystem::path file_;
    std::vector<Run> runs_;           ///< the latest first
    std::set<std::string> replaced_;  ///< pictures
};

/// As text, with its last line's end: names of files and in scenes need not be UTF-8.
std::string index_text(const nlohmann::ordered_json& index);

}  // namespace scb::app
