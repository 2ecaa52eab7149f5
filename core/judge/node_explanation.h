#pragma once

#include "core/explain/pair_explanation.h"
#include "core/model/node_volume.h"

namespace scb {

/// Explains a test of two nodes that another engine made, and that ended at this stage. Both
/// volumes must be there.
///
/// The certificate is that of exact_verdict with the engine's `tolerance`, sharpened, in A's frame.
/// The one step is along its direction or, where none separates the two, along the line of their
/// centers: how far both reach, and the gap. Where the engine let the pair pass, the step is marked
/// as not made. Where proven_verdict has none, the contact is touching.
PairExplanation explain_nodes(const NodeVolume& a, const NodeVolume& b, const Pose& b_to_a,
                              double tolerance, Stage ended);

}  // namespace scb
