#include "app/shards/shard_options.h"

#include "app/cli/command.h"
#include "app/cli/command_text.h"
#include "scb/error.h"

namespace scb::app {

std::optional<Shard> ShardOptions::asked() const {
    if (!is_shard()) return std::nullopt;
    try {
        return parse_shard(shard);
    } catch (const InputError& error) {
        throw InputError("--shard: " + std::string(error.what()));
    }
}

void ShardOptions::check_folder(const std::string& folder) const {
    if (is_shard() && folder.empty())
        throw InputError("--shard " + shard + ": say where to keep the shard, with -o DIR.");
}

void add_shard_options(const Command& command, ShardOptions& options, const std::string& parts) {
    options.words = [command] {
        // Output options differ from machine to machine, and are given to `scb merge` itself.
        return given_words(command, {"--shard", "--merged", "--output", "--jobs", "--open",
                                     "--terminal", "--video", "--fps"});
    };
    command
        .add_option(
            "--shard", options.shard,
            "Process share K of N of the " + parts + ", K from 1; `scb merge` joins the results")
        .type_name("K/N")
        .only_typed();
    command.add_option("--merged", options.merged, "").only_typed().hide();
}

void refuse_with_shard(const ShardOptions& options, bool given, const std::string& option,
                       const std::string& reason) {
    if ((options.is_shard() || options.is_merge()) && given)
        throw InputError(option + ": " + reason + "; leave it out, or --shard.");
}

}  // namespace scb::app
