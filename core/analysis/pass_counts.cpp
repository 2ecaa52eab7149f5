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

PassReason governing_reason(PassReason x, PassReason y) {
    for (const PassReason first :
         {PassReason::early, PassReason::weak_test, PassReason::unjudged, PassReason::loose_fit})
        if (x == first || y == first) return first;
    return PassReason::triangles_meet;
}

std::uint64_t WastedTests::all() const {
    return std::accumulate(by_reason.begin(), by_reason.end(), std::uint64_t{0});
}

WastedTests& WastedTests::operator+=(const WastedTests& other) {
    for (std::size_t i = 0; i < pass_reason_count; ++i) by_reason[i] += other.by_reason[i];
    return *this;
}

Work& Work::operator+=(const Work& other) {
    volume_tests += other.volume_tests;
    triangle_tests += other.triangle_tests;
    operations += other.operations;
    picoseconds += other.picoseconds;
    return *this;
}

Work PassCounts::wasted() const {
    Work sum;
    for (const Work& of_reason : wasted_for) sum += of_reason;
    return sum;
}

std::uint64_t PassCounts::passed() const {
    return std::accumulate(inner.begin(), inner.end(), std::uint64_t{0}) +
           std::accumulate(leaves.begin(), leaves.end(), std::uint64_t{0});
}

std::uint64_t PassCounts::passed(PassReason reason) const {
    const auto i = static_cast<std::size_t>(reason);
    return inner[i] + leaves[i];
}

void PassCounts::waste(PassReason reason, const Work& work) {
    if (reason == PassReason::triangles_meet) return;
    wasted_for[static_cast<std::size_t>(reason)] += work;
}

PassCounts& PassCounts::operator+=(const PassCounts& other) {
    for (std::size_t i = 0; i < pass_reason_count; ++i) {
        inner[i] += other.inner[i];
        leaves[i] += other.leaves[i];
        wasted_for[i] += other.wasted_for[i];
    }
    touching += other.touching;
    wrongly_rejected += other.wrongly_rejected;
    missed += other.missed;
    all += other.all;
    return *this;
}

}  // namespace scb
