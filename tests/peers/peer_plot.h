#pragma once

#include <span>

#include "tests/peers/comparison_group.h"

namespace scb {

/// A gnuplot script that draws `peers.png` where it runs: how many times as quick as FCL every peer
/// is on every scene, on one logarithmic scale; a row of panels for each group of scenes, warm at
/// the left, cold at the right. Its data is in the script.
std::string plot_script(std::span<const PeerKind> kinds, std::span<const ComparisonGroup> groups,
                        PeerQuery query);

}  // namespace scb
