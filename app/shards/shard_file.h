#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/platform/shard.h"

namespace scb::app {

/// The result of a shard for `scb merge`: DIR/shards/K-of-N.json. DIR has its pictures, if any.
struct ShardFile {
    Shard shard;
    std::vector<std::string> words;  ///< of the command line, the same in all shards
    nlohmann::ordered_json
        versions;           ///< of the programs that made it; other versions may draw differently
    std::string subject;    ///< a hash of the scene, see Parts
    std::size_t total = 0;  ///< parts of the whole run
    std::map<std::size_t, nlohmann::ordered_json> parts;  ///< by their numbers, from 0
    std::map<std::string, std::string> files;             ///< its files in DIR: a hash, by name
};

/// The command line that makes a shard of the run with these words: "scb render pairs spheres-l1
/// --shard 3/8 -o DIR".
std::string shard_command(const std::vector<std::string>& words, const std::string& shard);

/// The path of a shard's file in a folder of results; and the folder of other files of shards.
std::filesystem::path shard_path(const std::filesystem::path& folder, const Shard& shard);
std::filesystem::path shards_folder(const std::filesystem::path& folder);

/// Throws InputError if the file is no shard. Notes the file as an input.
ShardFile read_shard_file(const std::filesystem::path& path);

/// Makes the folder of shards of results in `folder`. Throws OutputError.
void make_shards_folder(const std::filesystem::path& folder);

/// Makes its folder too. Throws OutputError.
void write_shard_file(const std::filesystem::path& path, const ShardFile& shard);

/// A hash of the contents of a shard's file. Throws InputError if it cannot be read.
std::string file_hash(const std::filesystem::path& file);

/// Throws InputError to refuse a shard.
using ShardCheck = std::function<void(const std::filesystem::path&, const ShardFile&)>;

/// All shards of one run, in their order; sorts `paths` likewise. Throws InputError if shards are
/// missing, with the commands that make them; if shards are of other runs; if a file of a shard has
/// changed; or if `check` throws, which is called first for each shard.
std::vector<ShardFile> read_shards(std::vector<std::filesystem::path>& paths,
                                   const ShardCheck& check = {});

}  // namespace scb::app
