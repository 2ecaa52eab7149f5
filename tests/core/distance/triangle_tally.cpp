#include "tests/core/distance/triangle_tally.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include "scb/triangle_distance.h"
#include "tests/core/distance/proven_triangle_distance.h"

namespace scb {
namespace {

std::string text_of(const TrianglePair& pair, double found, const ProvenTriangleDistance& proven) {
    std::ostringstream out;
    out << std::setprecision(17) << found << " for " << proven.lower.high << " to "
        << proven.upper.high << ':';
    for (const TriangleCorners* t : {&pair.a, &pair.b})
        for (const Vec3& corner : *t) out << "\n  " << corner.transpose();
    return out.str();
}

/// How far the distance is beyond the bounds.
double error_of(double found, const ProvenTriangleDistance& proven) {
    return std::max({0.0, (proven.lower - precise::Real(found)).high,
                     (precise::Real(found) - proven.upper).high});
}

void add(TriangleTally& tally, const TrianglePair& pair) {
    const double found = triangle_distance(pair.a, pair.b).distance, allowed = allowed_error(pair);
    const bool meet = triangles_overlap(pair.a, pair.b);
    const ProvenTriangleDistance proven = proven_triangle_distance(pair.a, pair.b);
    ++tally.pairs;
    tally.intersecting += meet;
    tally.unproven += (proven.upper - proven.lower).high > 0x1p-20 * allowed;
    const double error = error_of(found, proven);
    if (allowed > 0) tally.worst = std::max(tally.worst, error / allowed);
    if (error <= allowed && (found == 0) == meet) return;
    if (tally.wrong++ == 0) tally.first_wrong = text_of(pair, found, proven);
}

}  // namespace

TrianglePair drawn_grid_pair(Random& random) { return as_doubles(random_grid_pair(random, 5)); }

TriangleTally& TriangleTally::operator+=(const TriangleTally& other) {
    pairs += other.pairs;
    intersecting += other.intersecting;
    wrong += other.wrong;
    unproven += other.unproven;
    worst = std::max(worst, other.worst);
    if (first_wrong.empty()) first_wrong = other.first_wrong;
    return *this;
}

TriangleTally tally_triangles(const TrianglePairFamily& family, std::uint64_t seed,
                              std::uint64_t pairs) {
    Random random(seed);
    TriangleTally tally;
    for (std::uint64_t i = 0; i < pairs; ++i) {
        TrianglePair pair = family.draw(random);
        const double scale = std::pow(10, random.uniform(-3, 3));
        for (TriangleCorners* t : {&pair.a, &pair.b})
            for (Vec3& corner : *t) corner *= scale;
        add(tally, pair);
    }
    return tally;
}

void print_triangle_header() {
    std::printf("%-22s %10s %12s %6s %9s %14s\n", "triangles", "pairs", "intersecting", "wrong",
                "unproven", "largest error");
}

void print_tally(std::string_view name, const TriangleTally& tally) {
    std::printf("%-22.*s %10" PRIu64 " %12" PRIu64 " %6" PRIu64 " %9" PRIu64 " %14.3f\n",
                static_cast<int>(name.size()), name.data(), tally.pairs, tally.intersecting,
                tally.wrong, tally.unproven, tally.worst);
    if (tally.wrong > 0) std::printf("%s\n", tally.first_wrong.c_str());
}

}  // namespace scb
