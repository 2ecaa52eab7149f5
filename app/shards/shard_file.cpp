#include "app/shards/shard_file.h"

#include <algorithm>

#include "core/base/text_format.h"
#include "core/platform/file_bytes.h"
#include "core/platform/input_files.h"
#include "core/platform/json_reader.h"
#include "core/platform/output_file.h"
#include "core/platform/tokens.h"
#include "golden/suite/case_command.h"
#include "scb/error.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

// The size of the file for a million pictures.
constexpr std::size_t largest_file = std::size_t{1} << 30;

std::string text_of(const Shard& shard) {
    return std::to_string(shard.k) + "/" + std::to_string(shard.n);
}

/// Words of other commands are never run.
bool can_be_shared(const std::string& command) {
    return command == "render" || command == "inspect" || command == "bench";
}

/// The sentence of an error as a clause.
std::string clause(std::string sentence) {
    if (sentence.ends_with('.')) sentence.pop_back();
    return sentence;
}

ShardFile shard_of(const Json& json) {
    ShardFile file;
    file.shard = parse_shard(json.at("shard").get_ref<const std::string&>());
    file.words = json.at("command").get<std::vector<std::string>>();
    if (file.words.empty() || !can_be_shared(file.words.front()))
        throw InputError("no command that can be shared made it");
    file.versions = json.at("versions");
    json.at("subject").get_to(file.subject);
    json.at("files").get_to(file.files);
    file.total = json.at("total").get<std::size_t>();
    for (const Json& part : json.at("parts")) {
        const auto number = part.at("number").get<std::size_t>();
        if (number >= file.total || !in_shard(file.shard, number))
            throw InputError("part " + std::to_string(number) + " is not of this shard");
        file.parts[number] = part.at("made");
    }
    for (std::size_t k = file.shard.k - 1; k < file.total; k += file.shard.n)
        if (!file.parts.contains(k)) throw InputError("part " + std::to_string(k) + " is missing");
    return file;
}

}  // namespace

std::string shard_command(const std::vector<std::string>& words, const std::string& shard) {
    std::string text = "scb";
    // The file may be a stranger's.
    constexpr std::size_t longest_word = 400;
    for (const std::string& word : words)
        text += " " + (word.size() <= longest_word ? golden::shell_word(word)
                                                   : golden::shell_word(excerpt(word)) + "...");
    return text + " --shard " + shard + " -o DIR";
}

namespace {

/// Without --models: each machine may have its meshes in another folder.
std::vector<std::string> with_models_anywhere(std::vector<std::string> words) {
    std::erase_if(words, [](const std::string& word) { return word.starts_with("--models="); });
    return words;
}

/// Throws if the shard is not of the same run as the first one.
void check_same_run(const ShardFile& first, const fs::path& first_path, const ShardFile& other,
                    const fs::path& path) {
    const std::string both = first_path.string() + " and " + path.string() + " are ";
    if (with_models_anywhere(first.words) != with_models_anywhere(other.words))
        throw InputError(both + "of different runs: `" + shard_command(first.words, "K/N") +
                         "` and `" + shard_command(other.words, "K/N") + "`; name those of one.");
    if (first.total != other.total || first.subject != other.subject)
        throw InputError(both +
                         "of different scenes: a mesh, a pose or the frames changed in "
                         "between; make both again.");
    if (first.shard.n != other.shard.n)
        throw InputError(both + "shards " + text_of(first.shard) + " and " + text_of(other.shard) +
                         "; name those of one division.");
    if (first.versions != other.versions)
        throw InputError(both + "made by different versions, " + first.versions.dump() + " and " +
                         other.versions.dump() + "; make both with the same.");
}

}  // namespace

fs::path shards_folder(const fs::path& folder) { return folder / "shards"; }

fs::path shard_path(const fs::path& folder, const Shard& shard) {
    return shards_folder(folder) /
           (std::to_string(shard.k) + "-of-" + std::to_string(shard.n) + ".json");
}

ShardFile read_shard_file(const fs::path& path) {
    const std::string name = path.string();
    note_input(path);
    const Json json = parse_ordered_json(read_text_file(name, largest_file), name);
    if (json.is_object() && json.contains("cases"))
        throw InputError(name +
                         ": these are results of `scb golden check`; join them with `scb golden "
                         "report`.");
    std::string reason;
    try {
        return shard_of(json);
    } catch (const Json::exception&) {
        reason = "this is no file of a shard";
    } catch (const InputError& error) {
        reason = clause(error.what());
    }
    throw InputError(name + ": " + reason + "; give what `--shard` has written.");
}

void make_shards_folder(const fs::path& folder) {
    const fs::path made = shards_folder(folder);
    std::error_code error;
    fs::create_directories(made, error);
    if (error || !fs::is_directory(made))
        throw OutputError(made.string() + ": this folder cannot be made" +
                          (error ? " (" + error.message() + ")" : "") + "; name another with -o.");
}

void write_shard_file(const fs::path& path, const ShardFile& shard) {
    Json parts = Json::array();
    for (const auto& [number, made] : shard.parts)
        parts.push_back({{"number", number}, {"made", made}});
    const Json json = {{"shard", text_of(shard.shard)}, {"command", shard.words},
                       {"versions", shard.versions},    {"subject", shard.subject},
                       {"total", shard.total},          {"parts", std::move(parts)},
                       {"files", shard.files}};
    make_shards_folder(path.parent_path().parent_path());
    write_file_whole(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string file_hash(const fs::path& file) { return short_hash(file_bytes(file.string())); }

std::vector<ShardFile> read_shards(std::vector<fs::path>& paths, const ShardCheck& check) {
    std::vector<std::pair<ShardFile, fs::path>> shards;
    for (const fs::path& path : paths) {
        shards.emplace_back(read_shard_file(path), path);
        if (check) check(path, shards.back().first);
        check_same_run(shards.front().first, shards.front().second, shards.back().first, path);
    }
    std::stable_sort(shards.begin(), shards.end(), [](const auto& x, const auto& y) {
        return x.first.shard.k < y.first.shard.k;
    });
    std::vector<ShardFile> ordered;
    for (std::size_t i = 0; i < shards.size(); ++i) {
        if (i > 0 && shards[i].first.shard == shards[i - 1].first.shard)
            throw InputError("shard " + text_of(shards[i].first.shard) + " is in " +
                             shards[i - 1].second.string() + " and in " +
                             shards[i].second.string() + "; give one of them.");
        paths[i] = shards[i].second;
        ordered.push_back(std::move(shards[i].first));
    }
    const std::size_t n = ordered.front().shard.n;
    for (std::size_t k = 1; k <= n; ++k)
        if (k > ordered.size() || ordered[k - 1].shard.k != k)
            throw InputError("shard " + text_of({k, n}) + " is missing; make it: " +
                             shard_command(ordered.front().words, text_of({k, n})));
    for (std::size_t i = 0; i < n; ++i)
        for (const auto& [file, hash] : ordered[i].files) {
            const fs::path path = paths[i].parent_path().parent_path() / file;
            if (!is_there(path) || file_hash(path) != hash)
                throw InputError(path.string() + ": the file is not as shard " +
                                 text_of(ordered[i].shard) + " made it; make this shard again: " +
                                 shard_command(ordered[i].words, text_of(ordered[i].shard)));
        }
    return ordered;
}

}  // namespace scb::app
