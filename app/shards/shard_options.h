#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/platform/shard.h"

namespace scb::app {

class Command;

/// Options of commands whose parts, such as frames, several machines can share.
struct ShardOptions {
    std::string shard;                ///< "K/N"; empty: all parts are made here
    std::vector<std::string> merged;  ///< the files of all shards, if they are joined here
    /// The words of the command line that are the same in all shards of a run; set if `shard` is.
    /// Valid as long as the command.
    std::function<std::vector<std::string>()> words{};

    bool is_shard() const { return !shard.empty(); }
    bool is_merge() const { return !merged.empty(); }
    /// Throws InputError if `shard` is invalid.
    std::optional<Shard> asked() const;
    /// Throws InputError if there is a shard but no folder.
    void check_folder(const std::string& folder) const;
};

/// --shard, and the hidden option that `scb merge` sets. `parts`: what the shards share, such as
/// "frames".
void add_shard_options(const Command& command, ShardOptions& options, const std::string& parts);

/// Throws InputError if the option is given with --shard.
void refuse_with_shard(const ShardOptions& options, bool given, const std::string& option,
                       const std::string& reason);

}  // namespace scb::app
