#include "app/study/tune_choice.h"

#include <algorithm>

#include "scb/any_packed.h"

namespace scb::app {

std::vector<std::size_t> best_rows(const std::vector<TuneRow>& all,
                                   const std::vector<Work>& counts) {
    std::vector<std::size_t> best;
    for (const std::size_t r : best_first(counts))
        if (is_sound(all[r].setting.overlap.test) && !all[r].misses_pairs &&
            (best.empty() || counts[best.back()] != counts[r]))
            best.push_back(r);
    return best;
}

std::size_t least_time_of(const std::vector<TuneRow>& all, const std::vector<std::size_t>& best) {
    const TuneRow* least = nullptr;
    for (const std::size_t r : best)
        if (all[r].ms && (least == nullptr || all[r].ms->median < least->ms->median))
            least = &all[r];
    const auto is_least = [&](std::size_t r) {
        return all[r].ms && !apart(*all[r].ms, *least->ms);
    };
    if (std::find(best.begin(), best.end(), 0u) != best.end() && is_least(0)) return 0;
    return *std::find_if(best.begin(), best.end(), is_least);
}

std::vector<std::size_t> timed_rows(const SceneTuning& tuning) {
    std::vector<std::size_t> timed = {0};
    const auto add = [&](std::size_t r) {
        if (std::find(timed.begin(), timed.end(), r) == timed.end()) timed.push_back(r);
    };
    for (const std::size_t r : tuning.listed(most_timed)) add(r);
    for (std::size_t r = 0; r < tuning.rows.size(); ++r)
        if (tuned(tuning.rows[r].setting, tuning.base().setting) == Tuned::split) add(r);
    if (tuning.fewest_tests) add(*tuning.fewest_tests);
    for (const VolumeKind kind : all_volume_kinds()) {
        const auto of_kind =
            std::find_if(tuning.best.begin(), tuning.best.end(),
                         [&](std::size_t r) { return tuning.rows[r].setting.volume == kind; });
        if (of_kind != tuning.best.end()) add(*of_kind);
    }
    return timed;
}

std::vector<std::size_t> packed_rows(const SceneTuning& tuning) {
    std::vector<std::size_t> fewest_first = tuning.best, packed;
    std::stable_sort(fewest_first.begin(), fewest_first.end(), [&](std::size_t x, std::size_t y) {
        return tuning.rows[x].counts < tuning.rows[y].counts;
    });
    for (const std::size_t r : fewest_first) {
        const VolumeKind kind = tuning.rows[r].setting.volume;
        if (can_pack(kind) && std::none_of(packed.begin(), packed.end(), [&](std::size_t other) {
                return tuning.rows[other].setting.volume == kind;
            }))
            packed.push_back(r);
    }
    return packed;
}

std::optional<std::size_t> quicker_layout_of(const SceneTuning& tuning) {
    std::vector<std::size_t> right;
    std::vector<TimeInterval> times;
    std::vector<double> bytes;
    for (std::size_t i = 0; i < tuning.layouts.size(); ++i) {
        const TuneLayout& layout = tuning.layouts[i];
        if (layout.misses_pairs) continue;
        right.push_back(i);
        times.push_back(*layout.ms);
        bytes.push_back(layout.bytes_per_triangle);
    }
    const auto found = quickest_with_least_memory(times, bytes, *tuning.rows[tuning.least_time].ms);
    return found ? std::optional(right[*found]) : std::nullopt;
}

std::optional<std::size_t> cheaper_layout_of(const SceneTuning& tuning) {
    const std::uint64_t unpacked = tuning.rows[tuning.best[0]].counts.picoseconds;
    std::vector<std::size_t> cheaper;
    for (std::size_t i = 0; i < tuning.layouts.size(); ++i) {
        const TuneLayout& layout = tuning.layouts[i];
        if (!layout.misses_pairs && layout.layout.width == QuickestCodec::width &&
            layout.layout.leaf_triangles == most_leaf_triangles && layout.picoseconds < unpacked)
            cheaper.push_back(i);
    }
    std::uint64_t least = unpacked;
    for (const std::size_t i : cheaper) least = std::min(least, tuning.layouts[i].picoseconds);
    std::optional<std::size_t> found;
    for (const std::size_t i : cheaper)
        if (10 * tuning.layouts[i].picoseconds <= 11 * least &&
            (!found ||
             tuning.layouts[i].bytes_per_triangle < tuning.layouts[*found].bytes_per_triangle))
            found = i;
    return found;
}

}  // namespace scb::app
