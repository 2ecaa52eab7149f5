#pragma once

#include "scb/overlap_options.h"
#include "scb/pose.h"
#include "scb/volume.h"

namespace scb {

/// Tests one pair of volumes, each in its own frame; `b_to_a` must be rigid. Returns the stage that
/// rejected the pair, or `overlapping`. The options are ignored for volumes other than Scb. Defined
/// for the types of volume.h. Throws nothing, allocates nothing.
template <Volume V>
Stage overlap(const V& a, const V& b, const Pose& b_to_a, const OverlapOptions& options = {});

}  // namespace scb
