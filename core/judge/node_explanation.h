#pragma once

#include "core/explain/pair_explanation.h"
#include "core/model/node_volume.h"

namespace scb {

/// Explains another engine's test of two nodes, which ended at stage `ended`. Both nodes must have
/// a volume.
///
/// The certificate is the result of exact_verdict with the engine's `tolerance`, sharpened, in A's
/// frame. The explanation has one step. It compares the extents of the volumes along the separating
/// direction or, if none separates them, along the line of their centers. The step is marked as
/// skipped if it separates a pair that the engine let pass. The contact is touching if
/// proven_verdict has no verdict.
PairExplanation explain_nodes(const NodeVolume& a, const NodeVolume& b, const Pose& b_to_a,
                              double tolerance, Stage ended);

}  // namespace scb
