#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace scb::app {

/// The index.json of a folder of pictures: the run that wrote it, and under `earlier` those before
/// it, the latest first, each with the pictures that no later run has replaced and nobody has
/// removed. At no time does the file describe a picture that is not the one in the folder. Several
/// programs may write pictures into one folder at the same time, as long as these have different
/// names: each change of the file is made under a lock of the folder, on what the file says by
/// then.
class FolderIndex {
  public:
    /// Reads the file where there is one. Throws InputError where that is none that scb wrote.
    explicit FolderIndex(std::filesystem::path file);

    /// To be called before a picture is replaced: takes the run that drew it out of the file, until
    /// write() puts back what is left of it. Throws OutputError, and as the constructor does.
    void about_to_write(const std::string& picture);

    /// Writes the file; `run` has the field `files`. Returns how many pictures it replaced of runs
    /// of another command or of other sources. Throws as about_to_write does.
    std::size_t write(const nlohmann::ordered_json& run);

  private:
    struct Run {
        nlohmann::ordered_json json;
        std::set<std::string> pictures;
    };
    /// A run that is not in the file now.
    struct TakenRun {
        Run run;
        std::size_t older = 0;  ///< how many runs were before it, those that are taken too
    };
    /// Which file it was, of those that had its name one after another.
    struct Version {
        std::uint64_t inode = 0;
        std::int64_t seconds = 0, nanoseconds = 0, size = -1;
        bool operator==(const Version&) const = default;
    };

    Version version() const;
    void read_if_changed();
    void write_runs();

    std::filesystem::path file_;
    Version read_;
    std::vector<Run> runs_;           ///< in the file, the latest first
    std::vector<TakenRun> taken_;     ///< the earliest first
    std::set<std::string> replaced_;  ///< pictures
    std::set<std::string> gone_;      ///< those of them that there were
};

/// As text, with its last line's end: names of files and in scenes need not be UTF-8.
std::string index_text(const nlohmann::ordered_json& index);

}  // namespace scb::app
