#include "tests/core/distance/gap_tally.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include "tests/core/distance/gap_pairs.h"
#include "tests/core/distance/inner_points.h"
#include "tests/core/packed/gap_keys.h"

namespace scb {
namespace {

template <class V>
std::string text_of(const GapPair<V>& pair, double bound, double distance) {
    const Vec3& a = pair.point_a;
    const Vec3& b = pair.point_b;
    std::ostringstream out;
    out << std::setprecision(17) << "bound " << bound << " above " << distance << ", drawn "
        << pair.gap << ", points " << a.transpose() << " and " << b.transpose() << "\nrotation "
        << pair.b_to_a.rotation.reshaped().transpose() << " translation "
        << pair.b_to_a.translation.transpose();
    return out.str();
}

template <class V>
void add(GapTally& tally, const GapPair<V>& pair, double bound, const precise::Real& distance,
         double lengths, double unit) {
    ++tally.pairs;
    tally.touching += pair.gap == 0;
    tally.positive += bound > 0;
    if (pair.gap > 0)
        tally.sum_of_shares += std::max(bound, 0.0) / std::max(distance.high, 0x1p-1000);
    if (bound > 0)
        tally.least_room =
            std::min(tally.least_room, (distance - precise::Real(bound)).high / (unit * lengths));
    if (!(distance < precise::Real(bound))) return;
    if (tally.above++ == 0) tally.first_above = text_of(pair, bound, distance.high);
}

/// `inside_a` and `inside_b`: two points, each in its own frame.
precise::Real distance_of(const precise::Point& inside_a, const precise::Point& inside_b,
                          const Pose& b_to_a) {
    using precise::operator-;
    return precise::length(precise::placed(b_to_a, inside_b) - inside_a);
}

/// How much farther apart points may be than drawn: they are rounded, and pulled into volumes.
bool is_loose(double gap, const precise::Real& distance, double lengths) {
    return distance.high > gap + 1e-9 * gap + 0x1p-44 * lengths;
}

template <class V>
double lengths_of(const GapPair<V>& pair) {
    return reach(pair.a) + reach(pair.b) + std::sqrt(squared_norm(pair.b_to_a.translation));
}

template <class V>
GapTally tally_volumes(std::uint64_t seed, std::uint64_t pairs) {
    Random random(seed);
    GapTally tally;
    for (std::uint64_t i = 0; i < pairs; ++i) {
        const GapPair<V> pair = drawn_gap_pair<V>(random);
        const double bound =
            volume_gap(pair.a, pair.b, placement(pair.b_to_a, reach(pair.a), reach(pair.b))).bound;
        const precise::Real distance =
            distance_of(precise::inner_point(pair.a, pair.point_a),
                        precise::inner_point(pair.b, pair.point_b), pair.b_to_a);
        tally.loose += is_loose(pair.gap, distance, lengths_of(pair));
        add(tally, pair, bound, distance, lengths_of(pair), 0x1p-53);
    }
    return tally;
}

/// A volume in a node: its floats, relative to an origin near it, or far away.
template <class V>
struct InNode {
    decltype(packed(V{}, Vec3())) volume;
    float origin[4] = {};
    float reach = 0;

    InNode(const V& v, Random& random) {
        const double away = random.below(2) == 0 ? 0 : v.r * random_power(random, -1, 1);
        for (int k = 0; k < 3; ++k)
            origin[k] = static_cast<float>(v.c[k] + away * random.uniform(-1, 1));
        volume = packed(v, at());
        reach = static_cast<float>(1.001 * std::sqrt(squared_norm(center(volume)))) + volume.r;
    }
    Vec3 at() const {
        return {static_cast<double>(origin[0]), static_cast<double>(origin[1]),
                static_cast<double>(origin[2])};
    }
    precise::Point inner_point(const Vec3& p) const {
        using precise::operator+;
        return precise::point(at()) + precise::inner_point(volume, Vec3(p - at()));
    }
};

template <class V>
GapTally tally_packed(std::uint64_t seed, std::uint64_t pairs, bool with_margin) {
    Random random(seed);
    GapTally tally;
    for (std::uint64_t i = 0; i < pairs; ++i) {
        const GapPair<V> pair = drawn_gap_pair<V>(random);
        const InNode<V> a(pair.a, random), b(pair.b, random);
        VolumesOfNodes<decltype(a.volume)> nodes{a.volume, b.volume, {}, {}, a.reach, b.reach};
        std::copy_n(a.origin, 4, nodes.origin_a);
        std::copy_n(b.origin, 4, nodes.origin_b);
        const Placement placed = placement(pair.b_to_a, reach(pair.a), reach(pair.b));
        const float key = gap_key(SimdLevel::best, nodes, placed, with_margin ? -1.0f : 0.0f);
        // Keys below 0 are no bounds.
        const double bound = std::max(0.0, static_cast<double>(key));
        const precise::Real distance =
            distance_of(a.inner_point(pair.point_a), b.inner_point(pair.point_b), pair.b_to_a);
        const Vec3 offset = transform_point(pair.b_to_a, b.at()) - a.at();
        const double lengths =
            static_cast<double>(a.reach) + static_cast<double>(b.reach) + offset.cwiseAbs().sum();
        tally.loose += is_loose(pair.gap, distance, lengths_of(pair));
        add(tally, pair, bound, distance, lengths, 0x1p-24);
    }
    return tally;
}

}  // namespace

GapTally& GapTally::operator+=(const GapTally& other) {
    pairs += other.pairs;
    touching += other.touching;
    positive += other.positive;
    above += other.above;
    loose += other.loose;
    sum_of_shares += other.sum_of_shares;
    least_room = std::min(least_room, other.least_room);
    if (first_above.empty()) first_above = other.first_above;
    return *this;
}

GapTally tally_gaps(VolumeKind kind, std::uint64_t seed, std::uint64_t pairs) {
    return with_volume_type(kind, [&]<Volume V>() { return tally_volumes<V>(seed, pairs); });
}

GapTally tally_packed_gaps(int slabs, std::uint64_t seed, std::uint64_t pairs, bool with_margin) {
    return slabs == 1 ? tally_packed<Scb>(seed, pairs, with_margin)
                      : tally_packed<Scb2>(seed, pairs, with_margin);
}

void print_gap_header() {
    std::printf("%-16s %10s %10s %10s %6s %6s %11s %11s\n", "volume", "pairs", "touching",
                "positive", "above", "loose", "mean share", "least room");
}

void print_tally(std::string_view name, const GapTally& tally) {
    std::printf("%-16.*s %10" PRIu64 " %10" PRIu64 " %10" PRIu64 " %6" PRIu64 " %6" PRIu64
                " %11.4f %11.2f\n",
                static_cast<int>(name.size()), name.data(), tally.pairs, tally.touching,
                tally.positive, tally.above, tally.loose,
                tally.sum_of_shares / static_cast<double>(tally.pairs - tally.touching),
                tally.least_room);
    if (tally.above > 0) std::printf("%s\n", tally.first_above.c_str());
}

}  // namespace scb
