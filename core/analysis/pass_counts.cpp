#include "core/analysis/pass_counts.h"

#include <numeric>

namespace scb {

std::vector<PassReason> waste_reasons(QueryKind kind) {
    std::vector<PassReason> reasons = {PassReason::loose_fit, PassReason::weak_test};
    if (kind == QueryKind::distance) reasons.push_back(PassReason::early);
    if (kind == QueryKind::distance || kind == QueryKind::within)
        reasons.push_back(PassReason::unjudged);
    return reasons;
}

Work& Work::operator+=(const Work& other) {
    volume_tests += other.volume_tests;
    triangle_tests += other.triangle_tests;
    operations += other.operations;
    picoseconds += other.picoseconds;
    return *this;
}

Work& Work::operator-=(const Work& other) {
    volume_tests -= other.volume_tests;
    triangle_tests -= other.triangle_tests;
    operations -= other.operations;
    picoseconds -= other.picoseconds;
    return *this;
}

std::uint64_t PassCounts::passed() const {
    return std::accumulate(inner.begin(), inner.end(), std::uint64_t{0}) +
           std::accumulate(leaves.begin(), leaves.end(), std::uint64_t{0});
}

std::uint64_t PassCounts::passed(PassReason reason) const {
    const auto i = static_cast<std::size_t>(reason);
    return inner[i] + leaves[i];
}

Work PassCounts::wasted_by_fit() const {
    Work rest = wasted;
    rest -= wasted_by_tests;
    rest -= wasted_early;
    return rest -= wasted_unjudged;
}

Work PassCounts::wasted_by(PassReason reason) const {
    switch (reason) {
        case PassReason::weak_test:
            return wasted_by_tests;
        case PassReason::loose_fit:
            return wasted_by_fit();
        case PassReason::triangles_meet:
            break;
        case PassReason::early:
            return wasted_early;
        case PassReason::unjudged:
            return wasted_unjudged;
    }
    return {};
}

PassCounts& PassCounts::operator+=(const PassCounts& other) {
    for (std::size_t i = 0; i < pass_reason_count; ++i) {
        inner[i] += other.inner[i];
        leaves[i] += other.leaves[i];
    }
    touching += other.touching;
    wrongly_rejected += other.wrongly_rejected;
    missed += other.missed;
    all += other.all;
    wasted += other.wasted;
    wasted_by_tests += other.wasted_by_tests;
    wasted_early += other.wasted_early;
    wasted_unjudged += other.wasted_unjudged;
    return *this;
}

}  // namespace scb
