#pragma once

#include "scb/overlap_options.h"
#include "scb/pose.h"
#include "scb/volume.h"

namespace scb {

/// Tests one pair of volumes: A in its own frame, B in its own, and B's pose as A sees it, which
/// must be rigid. Returns the stage that rejected the pair, or `overlapping`. Of all but Scb
/// the options say nothing. Defined for the types of volume.h. Throws nothing, allocates
/// nothing.
template <Volume V>
Stage overlap(const V& a, const V& b, const Pose& b_to_a, const OverlapOptions& options = {});

}  // namespace scb
