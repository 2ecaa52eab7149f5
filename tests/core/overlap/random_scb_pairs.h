#pragma once

#include <array>
#include <string_view>

#include "tests/core/overlap/volume_pairs.h"

namespace scb {

/// How a pair of SCBs is drawn. Angles between nearly (anti)parallel normals are spread over
/// 1e-9..1 evenly by order of magnitude, thicknesses over 1e-12..2 radii, one in eight zero, radii
/// over a ratio of 1e-3..1e3.
struct ScbPairFamily {
    enum class Normals { random, nearly_parallel, nearly_antiparallel };

    std::string_view name;
    Normals normals;
    bool centered;      ///< whether the slabs hold the centers: f <= 0 <= e, as for fitted SCBs
    bool near_contact;  ///< else: B anywhere that its ball meets the ball of A
};

inline constexpr std::array<ScbPairFamily, 9> scb_pair_families = {{
    {"contact, random", ScbPairFamily::Normals::random, true, true},
    {"contact, parallel", ScbPairFamily::Normals::nearly_parallel, true, true},
    {"contact, antiparallel", ScbPairFamily::Normals::nearly_antiparallel, true, true},
    {"contact, random, off-center", ScbPairFamily::Normals::random, false, true},
    {"contact, parallel, off-center", ScbPairFamily::Normals::nearly_parallel, false, true},
    {"contact, antiparallel, off-center", ScbPairFamily::Normals::nearly_antiparallel, false, true},
    {"scattered, random", ScbPairFamily::Normals::random, true, false},
    {"scattered, parallel", ScbPairFamily::Normals::nearly_parallel, true, false},
    {"scattered, antiparallel", ScbPairFamily::Normals::nearly_antiparallel, true, false},
}};

/// A pair, each SCB in a frame of its own.
struct ScbPair : VolumePair<Scb> {
    /// Near contact: how far the two were moved apart, along a common normal, from where they
    /// touch. Positive: their distance. Negative: B need not be moved farther than that to be rid
    /// of A.
    double gap = 0;
};

/// The same pairs on every machine: from the seed only by operations that IEEE 754 fixes.
///
/// A pair near contact is made from its contact: a direction is drawn (any; one of the normals;
/// tilted from a normal by 1e-9..1; between both normals), the points of A and B that are farthest
/// along and against it are put upon each other (any point of the disc where the direction is its
/// normal), and B is moved along it by 1e-9 of the larger radius up to a tenth of the smaller one,
/// outward or inward.
ScbPair random_scb_pair(Random& random, const ScbPairFamily& family);

/// A pair near contact that was moved by that share of the larger radius, outward or (negative)
/// inward.
ScbPair scb_pair_at_gap(Random& random, const ScbPairFamily& family, double gap);

/// A pair near contact that was not moved: the two share a point, up to rounding, and no more. Both
/// are `spread` times as far from the origins of their frames as other pairs.
ScbPair touching_scb_pair(Random& random, const ScbPairFamily& family, double spread);

/// Draws positive numbers evenly by order of magnitude (within a factor of 2).
double log_uniform(Random& random, double lower, double upper);

}  // namespace scb
