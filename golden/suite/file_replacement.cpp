#include "golden/suite/file_replacement.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "render/files/output_file.h"
#include "scenes/text/file_bytes.h"
#include "scenes/text/input_files.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

/// A temporary folder beside the files to replace, removed at the end.
class StagingFolder {
  public:
    explicit StagingFolder(const fs::path& beside) {
        std::string name = (beside / (std::string(replacement_prefix) + "XXXXXX")).string();
        if (::mkdtemp(name.data()) == nullptr)
            throw render::OutputError("Cannot write into \"" + beside.string() +
                                      "\": " + std::strerror(errno) +
                                      "; choose a folder that may be written, with room.");
        path_ = name;
    }
    ~StagingFolder() {
        std::error_code ignored;
        if (!kept_) fs::remove_all(path_, ignored);
    }
    StagingFolder(const StagingFolder&) = delete;
    StagingFolder& operator=(const StagingFolder&) = delete;

    const fs::path& path() const { return path_; }
    /// Keeps the folder: it has the only copy of a file.
    void keep() { kept_ = true; }

  private:
    fs::path path_;
    bool kept_ = false;
};

/// Puts files into their places and removes files: all of them or none.
class Replacement {
  public:
    explicit Replacement(const fs::path& folder) : staging_(folder) {}
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;

    /// Puts files with these contents into these places, and removes the others. Throws
    /// OutputError, InputError; then nothing has changed.
    void run(const std::vector<std::pair<fs::path, fs::path>>& changed,
             const std::vector<fs::path>& gone) {
        for (const auto& [source, target] : changed) scenes::refuse_input(target, "the update");
        for (const auto& [source, target] : changed)
            render::write_file_whole(staged(target), scenes::file_bytes(source.string()));
        try {
            for (const auto& [source, target] : changed) put(target);
            for (const fs::path& target : gone) remove(target);
        } catch (const render::OutputError& error) {
            const std::string lost = undo();
            if (lost.empty()) throw;
            throw render::OutputError(std::string(error.what()) + " " + lost);
        }
    }

  private:
    fs::path staged(const fs::path& target) const { return staging_.path() / target.filename(); }
    fs::path backup(const fs::path& target) const {
        return staging_.path() / ("old." + target.filename().string());
    }

    void put(const fs::path& target) {
        std::error_code error;
        // A second name, so that the target is never missing.
        if (render::is_there(target)) fs::create_hard_link(target, backup(target), error);
        if (error) fs::copy_file(target, backup(target), error);
        if (!error) fs::rename(staged(target), target, error);
        if (error)
            throw render::OutputError(target.string() + ": it cannot be replaced (" +
                                      error.message() + "); see that it may be written.");
        done_.push_back(target);
    }

    void remove(const fs::path& target) {
        std::error_code error;
        fs::rename(target, backup(target), error);
        if (error)
            throw render::OutputError(target.string() + ": it cannot be removed (" +
                                      error.message() + "); see that its folder may be written.");
        done_.push_back(target);
    }

    /// Names the files that could not be restored, a sentence each; empty if all were.
    std::string undo() {
        std::string lost;
        for (; !done_.empty(); done_.pop_back()) {
            const fs::path& target = done_.back();
            std::error_code error;
            if (render::is_there(backup(target)))
                fs::rename(backup(target), target, error);
            else
                fs::remove(target, error);
            if (!error) continue;
            staging_.keep();
            lost += (lost.empty() ? "" : " ") + target.string() +
                    " could not be restored; its old content is " + backup(target).string() + ".";
        }
        return lost;
    }

    StagingFolder staging_;
    std::vector<fs::path> done_;
};

}  // namespace

void replace_files(const fs::path& folder,
                   const std::vector<std::pair<fs::path, fs::path>>& changed,
                   const std::vector<fs::path>& gone) {
    Replacement(folder).run(changed, gone);
}

}  // namespace scb::golden
