#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "scb/any_hierarchy.h"

namespace scb {

/// Lower bounds of distances of volumes, compared with the distances of two points in double-double
/// arithmetic, which are in the volumes and at least as far apart.
struct GapTally {
    std::uint64_t pairs = 0, touching = 0;  ///< touching: drawn at the distance 0
    std::uint64_t positive = 0;             ///< bounds above 0
    std::uint64_t above = 0;                ///< bounds above the distance of the points
    /// Pairs whose points are farther apart than drawn, by more than rounding explains.
    std::uint64_t loose = 0;
    double sum_of_shares = 0;  ///< of bounds in the distances, for pairs that are apart
    /// The least room between a bound and the distance, in units of 2^-53 (volumes) or 2^-24
    /// (packed) of the lengths from which margins follow.
    double least_room = HUGE_VAL;
    std::string first_above;  ///< the numbers of the first pair with a bound above

    GapTally& operator+=(const GapTally& other);
};

/// Of volume_gap, for as many pairs of one kind of volume, drawn from the seed.
GapTally tally_gaps(VolumeKind kind, std::uint64_t seed, std::uint64_t pairs);
/// Of the packed volumes with one slab or two: bounds of the float lanes, at the best level. The
/// volumes are the sets that the stored floats define. Without the margin for floats if
/// `with_margin` is false.
GapTally tally_packed_gaps(int slabs, std::uint64_t seed, std::uint64_t pairs,
                           bool with_margin = true);

void print_gap_header();
/// A row: the counts, the mean share of bounds, and the least room.
void print_tally(std::string_view name, const GapTally& tally);

}  // namespace scb
