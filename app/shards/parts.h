#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/interrupt.h"
#include "app/shards/shard_file.h"
#include "app/shards/shard_options.h"

namespace scb::app {

/// The parts of a run, such as its frames, by numbers from 0. All are made here; or those of one
/// shard, whose results are kept in a file; or none, where shards have made them all.
class Parts {
  public:
    using Subject = std::function<nlohmann::ordered_json()>;

    /// A run that makes all of its parts.
    Parts() = default;
    /// `versions` of what makes them here; `subject`, asked where there are shards, tells the
    /// scene, with its poses, from others. A file of the same shard in `folder` is removed: it says
    /// nothing of what is made now. Throws InputError for shards of another run, or where a file of
    /// one is in the way.
    Parts(const ShardOptions& options, std::size_t total, nlohmann::ordered_json versions,
          const Subject& subject, std::filesystem::path folder);

    bool are_of_shard() const { return kept_.has_value(); }
    bool are_merged() const { return !merged_.empty(); }
    bool is_made_here(std::size_t k) const;
    /// How many of those from `first` to before `end` are made here.
    std::size_t count(std::size_t first, std::size_t end) const;

    /// Hands over what a shard made of a part, and the folder that has its files. Throws InputError
    /// where that cannot be read.
    using Read =
        std::function<void(const nlohmann::ordered_json& made, const std::filesystem::path&)>;
    void read(std::size_t k, const Read& use) const;

    /// Keeps what was made here of a part of a shard.
    void keep(std::size_t k, nlohmann::ordered_json made);
    /// Writes what was kept, to be called when all parts are made, and `files` in the folder that
    /// belong to it. Returns the file.
    std::filesystem::path write(const std::vector<std::string>& files = {});

  private:
    std::filesystem::path folder_;
    std::optional<ShardFile> kept_;
    std::vector<ShardFile> merged_;
    std::vector<std::filesystem::path> files_;  ///< of these
};

/// Writes the shard and prints its name, unless a signal came. Returns the exit status.
int finish_shard(Parts& parts, const InterruptWatch& watch, const Console& console);

}  // namespace scb::app
