#include <algorithm>
#include <memory>

#include "app/cli/commands.h"
#include "app/merge/shard_words.h"
#include "app/pictures/video_options.h"
#include "app/shards/shard_file.h"
#include "scb/error.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;

struct MergeOptions {
    std::vector<std::string> shards;
    std::string output;
    VideoOptions video;
};

/// The shards' files for a name: the file itself, or the files in a folder of results.
std::vector<fs::path> files_of(const fs::path& name) {
    std::error_code ignored;
    if (!fs::is_directory(name, ignored)) return {name};
    const fs::path folder =
        fs::is_directory(shards_folder(name), ignored) ? shards_folder(name) : name;
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    if (files.empty())
        throw InputError(name.string() +
                         ": no shard is in this folder; name one that --shard wrote to with -o.");
    std::sort(files.begin(), files.end());
    return files;
}

/// The words to run the program with to join the shards.
std::vector<std::string> merging_words(const MergeOptions& options, const Command& program,
                                       const Console& console) {
    std::vector<fs::path> files;
    for (const std::string& name : options.shards)
        for (fs::path& file : files_of(name)) files.push_back(std::move(file));
    const ReferenceCommand reference = reference_of_program(program);
    const auto check = [&](const fs::path& file, const ShardFile& shard) {
        check_shard_words(file, shard.words, reference);
    };
    const std::vector<std::string> of_shards = read_shards(files, check).front().words;
    console.note("scb: joins the shards of " + shard_command(of_shards, "K/N"));
    for (const fs::path& file : files) {
        std::error_code ignored;
        if (fs::equivalent(file.parent_path(), options.output, ignored))
            throw InputError("-o " + options.output +
                             ": this folder keeps the shards; name the one above it, or another.");
    }
    // The shards' words include the settings of configuration files.
    std::vector<std::string> words = {"--no-config"};
    if (console.quiet) words.emplace_back("--quiet");
    words.insert(words.end(), of_shards.begin(), of_shards.end());
    for (const fs::path& file : files) words.push_back("--merged=" + file.string());
    if (!options.output.empty()) words.push_back("--output=" + options.output);
    if (options.video.wanted()) words.push_back("--video=" + options.video.file);
    if (const auto rate = options.video.frames_per_second)
        words.push_back("--fps=" + std::to_string(*rate));
    return words;
}

}  // namespace

void add_merge(const Command& program, const Console& console, const RunAgain& run_again,
               Action& action) {
    const Command command = program.add_subcommand(
        "merge", "Join the shards of a run: its index, tables, sheets and animations");
    const auto options = std::make_shared<MergeOptions>();
    command
        .add_option("SHARD", options->shards,
                    "Folders that --shard wrote to with -o, or the files in their shards/")
        .required()
        .expected(1, 1'000'000)
        .file({".json"});
    command
        .add_option("-o,--output", options->output,
                    "Folder for the results; it may be the folder of the shards")
        .folder()
        .only_typed();
    add_video_options(command, options->video);
    command.footer(
        "Several machines share a run: each makes some frames, by --shard of `scb render ...`, "
        "`inspect` or `bench`. The result\nhas the same bytes as a run on one machine, except for "
        "times of `scb bench`. The command reads the scene again. All\nshards must come from the "
        "same versions of scb and of its graphics libraries.\n\n"
        "Example:\n"
        "  scb render pairs spheres-l1 --frames all --sheet --shard 1/2 -o out/\n"
        "  scb render pairs spheres-l1 --frames all --sheet --shard 2/2 -o out/\n"
        "  scb merge out/ -o out/");
    command.callback([&action, &console, &run_again, command, options] {
        action = [&, command, options] {
            return run_again(merging_words(*options, command, console));
        };
    });
}

}  // namespace scb::app
