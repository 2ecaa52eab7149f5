#include "core/analysis/assumed_time.h"

#include <algorithm>
#include <cassert>

#include "core/analysis/cost_equation.h"

namespace scb {
namespace {

/// In picoseconds.
struct VolumeTimes {
    std::uint64_t test;  ///< of any end
    /// By end: with overlapping volumes, at the first bound, and at a later bound.
    std::uint64_t overlapping, at_first, later;
    std::uint64_t measures;  ///< of both nodes of a division, by area or volume
};

/// `percent` of the times of the symmetric test for slab cut balls with one slab.
constexpr VolumeTimes one_slab(std::uint64_t percent) {
    return {220 * percent, 280 * percent, 60 * percent, 220 * percent, 5'000};
}

VolumeTimes times_of(VolumeKind volume, OverlapTest test) {
    switch (volume) {
        case VolumeKind::scb:
            switch (test) {
                case OverlapTest::symmetric:
                    return one_slab(100);
                case OverlapTest::extents:
                    return one_slab(180);
                case OverlapTest::corrected:
                    return one_slab(112);
                case OverlapTest::line8:
                case OverlapTest::printed:
                    return one_slab(109);
            }
            break;
        case VolumeKind::ball:
            return {14'000, 11'000, 25'000, 14'000, 0};
        case VolumeKind::ritter:
            return {14'000, 12'000, 19'000, 14'000, 0};
        case VolumeKind::obb:
            return {42'000, 45'000, 41'000, 40'000, 6'000};
        case VolumeKind::scb2:
            return {153'000, 156'000, 122'000, 164'000, 430'000};
        case VolumeKind::aabb:
            return {18'000, 21'000, 16'000, 18'000, 3'000};
        case VolumeKind::aabb_exact:
            return {32'000, 33'000, 17'000, 61'000, 3'000};
        case VolumeKind::dop14:
            return {860'000, 620'000, 1'360'000, 1'420'000, 0};
        case VolumeKind::dop18:
            return {940'000, 510'000, 1'800'000, 1'990'000, 0};
        case VolumeKind::dop26:
            return {1'180'000, 440'000, 2'450'000, 3'200'000, 0};
        case VolumeKind::rss:
            return {191'000, 235'000, 68'000, 225'000, 30'000};
        case VolumeKind::capsule:
            return {88'000, 103'000, 31'000, 133'000, 13'000};
    }
    assert(false && "a volume of this project");
    return {};
}

/// The tests that ended at the first bound of the volume's test, which is cheap: of the balls,
/// along A's axes, or along the line of centers.
std::uint64_t ended_at_first(VolumeKind volume, const StageCounts& stages) {
    const auto count = [&stages](Stage stage) { return stages[static_cast<std::size_t>(stage)]; };
    switch (volume) {
        case VolumeKind::obb:
        case VolumeKind::aabb:
        case VolumeKind::aabb_exact:
            return count(Stage::axis_a0) + count(Stage::axis_a1) + count(Stage::axis_a2);
        case VolumeKind::dop14:
        case VolumeKind::dop18:
        case VolumeKind::dop26:
        case VolumeKind::rss:
        case VolumeKind::capsule:
            return count(Stage::center_line);
        default:
            return count(Stage::ball_ball);
    }
}

/// Of the distance of two triangles, in picoseconds.
constexpr std::uint64_t distance_triangle_time = 225'000;

/// Of one bound, in picoseconds.
std::uint64_t bound_time(VolumeKind volume) {
    switch (volume) {
        case VolumeKind::scb:
        case VolumeKind::rss:
            return 500'000;
        case VolumeKind::scb2:
            return 565'000;
        case VolumeKind::obb:
        case VolumeKind::capsule:
            return 350'000;
        case VolumeKind::aabb:
        case VolumeKind::aabb_exact:
            return 220'000;
        case VolumeKind::ball:
        case VolumeKind::ritter:
            return 120'000;
        case VolumeKind::dop14:
        case VolumeKind::dop18:
        case VolumeKind::dop26:
            break;
    }
    return 3'200'000;
}

}  // namespace

std::uint64_t assumed_test_time(VolumeKind volume, OverlapTest test) {
    return times_of(volume, test).test;
}

std::uint64_t least_test_time(VolumeKind volume, OverlapTest test) {
    const VolumeTimes times = times_of(volume, test);
    return std::min({times.overlapping, times.at_first, times.later});
}

std::uint64_t assumed_time(VolumeKind volume, const OverlapOptions& overlap, DescentRule descent,
                           const Collision& found) {
    constexpr std::uint64_t pair = 215'000;
    const VolumeTimes times = times_of(volume, overlap.test);
    const std::uint64_t passed = found.stages[static_cast<std::size_t>(Stage::overlapping)],
                        at_first = ended_at_first(volume, found.stages),
                        later = found.n_v - passed - at_first;
    // Each pair of leaves that passes leads to a test of triangles, each other pair to a division.
    const std::uint64_t divisions = passed - std::min(passed, found.n_p);
    const bool measured = descent == DescentRule::area || descent == DescentRule::volume;
    return times.overlapping * passed + times.at_first * at_first + times.later * later +
           (measured ? times.measures * divisions : 0) + assumed_triangle_time * found.n_p +
           pair * found.pairs.size();
}

std::uint64_t assumed_distance_time(VolumeKind volume, const std::optional<PackedLayout>& layout,
                                    std::uint64_t queries, std::uint64_t n_v, std::uint64_t n_p) {
    if (!layout) return bound_time(volume) * n_v + distance_triangle_time * n_p;
    const std::uint64_t bound = volume == VolumeKind::scb ? 35'000 : 40'000;
    const bool indexed = layout->corners == LeafCorners::in_mesh,
               quantized = layout->numbers == PackedLayout::Numbers::quantized;
    const std::uint64_t query = indexed ? 5'500'000 : quantized ? 7'500'000 : 14'000'000;
    return bound * n_v + distance_triangle_time * n_p + query * queries;
}

TestCosts assumed_costs(const TraceHeader& header) {
    const VolumeKind volume = header.engine ? VolumeKind::aabb : header.volume;
    if (is_of_distance(header.kind))
        return {static_cast<double>(bound_time(volume)),
                static_cast<double>(distance_triangle_time)};
    return {static_cast<double>(assumed_test_time(volume, header.options.overlap.test)),
            static_cast<double>(assumed_triangle_time)};
}

Work work_of(VolumeKind volume, const OverlapOptions& overlap, DescentRule descent,
             const Collision& found) {
    return {found.n_v, found.n_p, operation_count(volume, overlap, found.stages),
            assumed_time(volume, overlap, descent, found)};
}

}  // namespace scb
