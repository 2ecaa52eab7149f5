#include "app/shards/parts.h"

#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/platform/output_file.h"
#include "scb/error.h"

namespace scb::app {

using Json = nlohmann::ordered_json;

namespace {

/// Whether the file is a shard of the run with these words.
bool is_of_run(const std::filesystem::path& file, const std::vector<std::string>& words) {
    try {
        return read_shard_file(file).words == words;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

Parts::Parts(const ShardOptions& options, std::size_t total, Json versions, const Subject& subject,
             std::filesystem::path folder)
    : folder_(std::move(folder)) {
    if (!options.is_shard() && !options.is_merge()) return;
    const std::string hash =
        short_hash(subject().dump(-1, ' ', false, Json::error_handler_t::replace));
    if (const std::optional<Shard> shard = options.asked()) {
        kept_ = ShardFile{*shard, options.words(), std::move(versions), hash, total, {}, {}};
        const std::filesystem::path file = shard_path(folder_, *shard);
        if (!is_there(file)) return;
        if (!is_of_run(file, kept_->words))
            throw InputError(file.string() +
                             ": this is the shard of another run, or a damaged one; remove it, or "
                             "name another folder with -o.");
        std::error_code ignored;
        std::filesystem::remove(file, ignored);
    } else if (options.is_merge()) {
        files_.assign(options.merged.begin(), options.merged.end());
        merged_ = read_shards(files_);
        const ShardFile& first = merged_.front();
        if (first.versions != versions)
            throw InputError(files_.front().string() + " was made by other versions, " +
                             first.versions.dump() + ", than these, " + versions.dump() +
                             "; merge where it was made.");
        if (first.total != total || first.subject != hash)
            throw InputError(files_.front().string() +
                             ": the scene has changed since this was made, a mesh, a pose or the "
                             "frames; make all shards again.");
    }
}

bool Parts::is_made_here(std::size_t k) const {
    return !are_merged() && (!kept_ || in_shard(kept_->shard, k));
}

std::size_t Parts::count(std::size_t first, std::size_t end) const {
    std::size_t count = 0;
    for (std::size_t k = first; k < end; ++k) count += is_made_here(k);
    return count;
}

void Parts::read(std::size_t k, const Read& use) const {
    const std::size_t i = k % merged_.size();
    try {
        use(merged_[i].parts.at(k), files_[i].parent_path().parent_path());
    } catch (const Json::exception& error) {
        throw InputError(files_[i].string() + ": part " + std::to_string(k) +
                         " is damaged; make this shard again.");
    }
}

void Parts::keep(std::size_t k, Json made) { kept_->parts[k] = std::move(made); }

std::filesystem::path Parts::write(const std::vector<std::string>& files) {
    for (const std::string& name : files) kept_->files[name] = file_hash(folder_ / name);
    const std::filesystem::path file = shard_path(folder_, kept_->shard);
    write_shard_file(file, *kept_);
    return file;
}

int finish_shard(Parts& parts, const InterruptWatch& watch, const Console& console) {
    if (watch.signal() == 0) {
        print_result(parts.write().string() + "\n");
        return exit_done;
    }
    console.note("scb: interrupted; the shard is to be made again.");
    return exit_interrupted(watch.signal());
}

}  // namespace scb::app
