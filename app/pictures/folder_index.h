#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace scb::app {

/// The index.json of a folder of pictures: the latest run, and under `earlier` the runs before it,
/// the latest first. Each has its pictures that still exist and that no later run has replaced. The
/// file never describes a picture that is not the one in the folder. Several programs may write
/// pictures of different names into one folder at the same time: each change of the file locks the
/// folder and starts from the file's current contents.
class FolderIndex {
  public:
    /// Reads the file if it exists. Throws InputError if it is not an index written by scb.
    explicit FolderIndex(std::filesystem::path file);

    /// Call this before a picture is replaced: removes the run that drew it from the file, until
    /// write() puts back the rest of the run. Throws OutputError, and as the constructor does.
    void about_to_write(const std::string& picture);

    /// Writes the file; `run` has the field `files`. Returns the number of replaced pictures that
    /// came from another command or other inputs. Throws as about_to_write does.
    std::size_t write(const nlohmann::ordered_json& run);

  private:
    struct Run {
        nlohmann::ordered_json json;
        std::set<std::string> pictures;
    };
    /// A run that is not in the file at present.
    struct TakenRun {
        Run run;
        std::size_t older = 0;  ///< number of earlier runs, including removed ones
    };
    /// Identifies one of the files that had this name one after another.
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
    std::set<std::string> gone_;      ///< the replaced pictures that existed
};

/// The index as text, with a final line end. Invalid UTF-8 in names is replaced.
std::string index_text(const nlohmann::ordered_json& index);

}  // namespace scb::app
