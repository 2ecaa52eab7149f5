#pragma once

#include "scb/packed_scb.h"
#include "scb/packed_scb2.h"
#include "scb/placement.h"
#include "scb/simd_level.h"
#include "tests/core/packed/kernel_pairs.h"

namespace scb {

/// The key that the kernel of packed distances gives two volumes, with a margin of so many units;
/// of gap_bound if they are negative. A key above 0 is a lower bound of their distance.
float gap_key(SimdLevel level, const VolumesOfNodes<PackedScb>& pair, const Placement& placed,
              float units);
float gap_key(SimdLevel level, const VolumesOfNodes<PackedScb2>& pair, const Placement& placed,
              float units);

}  // namespace scb
