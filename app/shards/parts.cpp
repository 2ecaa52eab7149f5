#include "app/shards/parts.h"

#include "core/base/exit_status.h"
#include "render/files/output_file.h"
#include "scb/error.h"

namespace scb::app {

using Json = nlohmann::ordered_json;

Parts::Parts(const ShardOptions& options, std::size_t total, Json versions,
             std::filesystem::path folder)
    : total_(total), folder_(std::move(folder)) {
    if (const std::optional<scenes::Shard> shard = options.asked()) {
        kept_ = ShardFile{*shard, options.words(), std::move(versions), total, {}};
        const std::filesystem::path file = shard_path(folder_, *shard);
        if (render::is_there(file) && read_shard_file(file).words != kept_->words)
            throw InputError(file.string() +
                             " is the shard of another run; remove it, or name another folder "
                             "with -o.");
    } else if (options.is_merge()) {
        files_.assign(options.merged.begin(), options.merged.end());
        merged_ = read_shards(files_);
        const ShardFile& first = merged_.front();
        if (first.versions != versions)
            throw InputError(files_.front().string() + " was made by other versions, " +
                             first.versions.dump() + ", than these, " + versions.dump() +
                             "; merge where it was made.");
        if (first.total != total || first.words != options.words())
            throw InputError(files_.front().string() + " has " + std::to_string(first.total) +
                             " parts, and the run has " + std::to_string(total) +
                             "; its scene has changed since: make all shards again.");
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

std::filesystem::path Parts::write() const {
    const std::filesystem::path file = shard_path(folder_, kept_->shard);
    write_shard_file(file, *kept_);
    return file;
}

int finish_shard(const Parts& parts, const InterruptWatch& watch, const Console& console) {
    if (watch.signal() == 0) {
        print_result(parts.write().string() + "\n");
        return exit_done;
    }
    console.note("scb: interrupted; the shard is to be made again.");
    return exit_interrupted(watch.signal());
}

}  // namespace scb::app
