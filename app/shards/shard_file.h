#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/text/shard.h"

namespace scb::app {

/// What a shard of a run leaves for `scb merge`: DIR/shards/K-of-N.json, where DIR has its
/// pictures, if it made any.
struct ShardFile {
    scenes::Shard shard;
    std::vector<std::string> words;   ///< of the command line, the same in all shards
    nlohmann::ordered_json versions;  ///< of what made it; other versions may draw otherwise
    std::string subject;              ///< a hash of the scene, see Parts
    std::size_t total = 0;            ///< parts of the whole run
    std::map<std::size_t, nlohmann::ordered_json> parts;  ///< by their numbers, from 0
    std::map<std::string, std::string> files;  ///< those that it made: by name, in DIR, a hash
};

/// The command line that makes a shard of the run of these words: "scb render pairs spheres-l1
/// --shard 3/8 -o DIR".
std::string shard_command(const std::vector<std::string>& words, const std::string& shard);

/// Where the shard of results in that folder is; and where other files of shards are.
std::filesystem::path shard_path(const std::filesystem::path& folder, const scenes::Shard& shard);
std::filesystem::path shards_folder(const std::filesystem::path& folder);

/// Throws InputError where it is none. Notes it as an input.
ShardFile read_shard_file(const std::filesystem::path& path);

/// Makes the folder of shards of results in `folder`. Throws OutputError.
void make_shards_folder(const std::filesystem::path& folder);

/// Makes its folder too. Throws OutputError.
void write_shard_file(const std::filesystem::path& path, const ShardFile& shard);

/// A hash of what is in a file of a shard. Throws InputError where it cannot be read.
std::string file_hash(const std::filesystem::path& file);

/// Throws InputError where a shard is refused.
using ShardCheck = std::function<void(const std::filesystem::path&, const ShardFile&)>;

/// All shards of one run, in their order; `paths` get that order too. Throws InputError where some
/// are missing or are of other runs, and says how the missing ones are made; also where a file that
/// one made is not as it was, and where `check`, which sees each before others, does.
std::vector<ShardFile> read_shards(std::vector<std::filesystem::path>& paths,
                                   const ShardCheck& check = {});

}  // namespace scb::app
