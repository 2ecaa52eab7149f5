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

/// The parts of a run, such as its frames, numbered from 0. Either this process makes all parts; or
/// it makes those of one shard, and keeps their results in a file; or it makes none, since shards
/// have made them all.
class Parts {
  public:
    using Subject = std::function<nlohmann::ordered_json()>;

    /// A run that makes all of its parts.
    Parts() = default;
    /// `versions`: of the programs here. `subject`: identifies the scene with its poses; called
    /// only if there are shards. Removes the file of the same shard in `folder`, which is out of
    /// date. Throws InputError for shards of another run, or if another run's file is in the way.
    Parts(const ShardOptions& options, std::size_t total, nlohmann::ordered_json versions,
          const Subject& subject, std::filesystem::path folder);

    bool are_of_shard() const { return kept_.has_value(); }
    bool are_merged() const { return !merged_.empty(); }
    bool is_made_here(std::size_t k) const;
    /// The number of parts in [first, end) that are made here.
    std::size_t count(std::size_t first, std::size_t end) const;

    /// Passes on a shard's result of a part, and the folder of its files. Throws InputError if they
    /// cannot be read.
    using Read =
        std::function<void(const nlohmann::ordered_json& made, const std::filesystem::path&)>;
    void read(std::size_t k, const Read& use) const;

    /// Keeps the result of a part that was made here, for the shard's file.
    void keep(std::size_t k, nlohmann::ordered_json made);
    /// Writes the kept results and the names of `files` in the folder. Call this when all parts are
    /// made. Returns the file.
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
