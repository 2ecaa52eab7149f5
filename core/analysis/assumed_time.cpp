#include "core/analysis/assumed_time.h"

#include <algorithm>
#include <cassert>

#include "core/analysis/cost_equation.h"

namespace scb {
namespace {

/// In picoseconds.
struct VolumeTimes {
    std::uint64_t test;
    std::uint64_t measures;  ///< of both nodes of a division, by area or volume
};

VolumeTimes times_of(VolumeKind volume, OverlapTest test) {
    switch (volume) {
        case VolumeKind::scb:
            switch (test) {
                case OverlapTest::symmetric:
                    return {33'000, 5'000};
                case OverlapTest::extents:
                    return {60'000, 5'000};
                case OverlapTest::corrected:
                    return {37'000, 5'000};
                case OverlapTest::line8:
                case OverlapTest::printed:
                    return {36'000, 5'000};
            }
            break;
        case VolumeKind::ball:
        case VolumeKind::ritter:
            return {18'000, 0};
        case VolumeKind::obb:
            return {48'000, 6'000};
        case VolumeKind::scb2:
            return {180'000, 430'000};
        case VolumeKind::aabb:
            return {23'000, 3'000};
        case VolumeKind::aabb_exact:
            return {37'000, 3'000};
        case VolumeKind::dop14:
            return {790'000, 0};
        case VolumeKind::dop18:
            return {800'000, 0};
        case VolumeKind::dop26:
            return {990'000, 0};
        case VolumeKind::rss:
            return {230'000, 30'000};
        case VolumeKind::capsule:
            return {99'000, 13'000};
    }
    assert(false && "a volume of this project");
    return {};
}

}  // namespace

std::uint64_t assumed_test_time(VolumeKind volume, OverlapTest test) {
    return times_of(volume, test).test;
}

std::uint64_t assumed_time(VolumeKind volume, const OverlapOptions& overlap, DescentRule descent,
                           const Collision& found) {
    constexpr std::uint64_t pair = 150'000;
    const VolumeTimes times = times_of(volume, overlap.test);
    const std::uint64_t passed = found.stages[static_cast<std::size_t>(Stage::overlapping)];
    // Each pair of leaves that passes leads to a test of triangles, each other pair to a division.
    const std::uint64_t divisions = passed - std::min(passed, found.n_p);
    const bool measured = descent == DescentRule::area || descent == DescentRule::volume;
    return times.test * found.n_v + (measured ? times.measures * divisions : 0) +
           assumed_triangle_time * found.n_p + pair * found.pairs.size();
}

TestCosts assumed_costs(const TraceHeader& header) {
    const VolumeKind volume = header.engine ? VolumeKind::aabb : header.volume;
    return {static_cast<double>(assumed_test_time(volume, header.options.overlap.test)),
            static_cast<double>(assumed_triangle_time)};
}

Work work_of(VolumeKind volume, const OverlapOptions& overlap, DescentRule descent,
             const Collision& found) {
    return {found.n_v, found.n_p, operation_count(volume, overlap, found.stages),
            assumed_time(volume, overlap, descent, found)};
}

}  // namespace scb
