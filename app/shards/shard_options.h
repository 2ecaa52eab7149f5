#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "scenes/text/shard.h"

namespace scb::app {

/// What a command understands whose parts, such as its frames, several machines can share.
struct ShardOptions {
    std::string shard;                ///< "K/N"; empty: all parts are made here
    std::vector<std::string> merged;  ///< the files of all shards, where their parts are joined
    std::optional<Command> command{};

    bool is_shard() const { return !shard.empty(); }
    bool is_merge() const { return !merged.empty(); }
    /// Throws InputError for what is no shard.
    std::optional<scenes::Shard> asked() const;
    /// A shard needs a folder. Throws InputError where there is none.
    void check_folder(const std::string& folder) const;
    /// The words of the command line that all shards of a run have in common.
    std::vector<std::string> words() const;
};

/// --shard, and what `scb merge` gives. `parts`: what the shards share, such as "frames".
void add_shard_options(const Command& command, ShardOptions& options, const std::string& parts);

/// Throws InputError where the option is given with --shard.
void refuse_with_shard(const ShardOptions& options, bool given, const std::string& option,
                       const std::string& reason);

}  // namespace scb::app
