#include "golden/suite/file_replacement.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "core/platform/file_bytes.h"
#include "core/platform/input_files.h"
#include "core/platform/output_file.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

/// A temporary folder beside the files to replace, removed at the end.
class StagingFolder {
  public:
    explicit StagingFolder(const fs::path& beside) {
        std::string name = (beside / (std::string(replacement_prefix) + "XXXXXX")).string();
        if (::mkdtemp(name.data()) == nullptr)
            throw OutputError("Cannot write into \"" + beside.string() +
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
        for (const auto& [source, target] : changed) refuse_input(target, "the update");
        for (const auto& [source, target] : changed)
            write_file_whole(staged(target), file_bytes(source.string()));
        try {
            for (const auto& [source, target] : changed) put(target);
            for (const fs::path& target : gone) remove(target);
        } catch (const OutputError& error) {
            const std::string lost = undo();
            if (lost.empty()) throw;
            throw OutputError(std::string(error.what()) + " " + lost);
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
        if (is_there(target)) fs::create_hard_link(target, backup(target), error);
        if (error) fs::copy_file(target, backup(target), error);
        if (!error) fs::rename(staged(target), target, error);
        if (error)
            throw OutputError(target.string() + ": it cannot be replaced (" + error.message() +
                              "); see that it may be written.");
        done_.push_back(target);
    }

    void remove(const fs::path& target) {
        std::error_code error;
        fs::rename(target, backup(target), error);
        if (error)
            throw OutputError(target.string() + ": it cannot be removed (" + error.message() +
                              "); see that its folder may be written.");
        done_.push_back(target);
    }

    /// Names the files that could not be restored, a sentence each; empty if all were.
    std::string undo() {
        std::string lost;
        for (; !done_.empty(); done_.pop_back()) {
            const fs::path& target = done_.back();
            std::error_code error;
            if (is_there(backup(target)))
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

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File open_file(const std::filesystem::path& path) {
    return {std::fopen(path.c_str(), "rb"), std::fclose};
}

}  // namespace

bool files_equal(const std::filesystem::path& a, const std::filesystem::path& b) {
    // Sizes are known without reading; folders and missing files have none.
    std::error_code no_size_a, no_size_b;
    const auto size_a = std::filesystem::file_size(a, no_size_a),
               size_b = std::filesystem::file_size(b, no_size_b);
    if (no_size_a || no_size_b || size_a != size_b) return false;
    const File file_a = open_file(a), file_b = open_file(b);
    if (!file_a || !file_b) return false;
    constexpr std::size_t block = std::size_t{1} << 16;  // stacks may be smaller
    std::vector<char> block_a(block), block_b(block);
    for (;;) {
        const std::size_t read_a = std::fread(block_a.data(), 1, block_a.size(), file_a.get()),
                          read_b = std::fread(block_b.data(), 1, block_b.size(), file_b.get());
        if (read_a != read_b || std::memcmp(block_a.data(), block_b.data(), read_a) != 0)
            return false;
        if (read_a < block_a.size())
            return std::ferror(file_a.get()) == 0 && std::ferror(file_b.get()) == 0;
    }
}

}  // namespace scb::golden
