#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/core/geometry/distance_pairs.h"

namespace scb {

/// How pairs of triangles are drawn.
struct TrianglePairFamily {
    std::string_view name;
    TrianglePair (*draw)(Random& random);
};
TrianglePair drawn_grid_pair(Random& random);
inline constexpr std::array<TrianglePairFamily, 7> triangle_pair_families = {{
    {"any shapes", random_shapes},
    {"edges nearly parallel", nearly_parallel},
    {"slivers", random_slivers},
    {"corner above face", corner_above},
    {"nearly coplanar", nearly_coplanar_pair},
    {"stacked", stacked},
    {"grid", drawn_grid_pair},
}};

/// Distances of triangles, compared with proven bounds of them.
struct TriangleTally {
    std::uint64_t pairs = 0, intersecting = 0;
    std::uint64_t wrong = 0;  ///< off by more than allowed_error, or 0 where they do not intersect
    std::uint64_t unproven =
        0;             ///< proven bounds that differ by more than 2^-70 of the coordinates
    double worst = 0;  ///< error, as a share of allowed_error
    std::string first_wrong;

    TriangleTally& operator+=(const TriangleTally& other);
};

/// As many pairs of a family, drawn from the seed, at scales from 1e-3 to 1e3.
TriangleTally tally_triangles(const TrianglePairFamily& family, std::uint64_t seed,
                              std::uint64_t pairs);

void print_triangle_header();
void print_tally(std::string_view name, const TriangleTally& tally);

}  // namespace scb
