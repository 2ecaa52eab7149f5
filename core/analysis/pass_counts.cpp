#include "core/analysis/pass_counts.h"

#include <numeric>

namespace scb {

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
    return rest -= wasted_by_tests;
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
    return *this;
}

}  // namespace scb
