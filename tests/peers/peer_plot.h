#pragma once

#include <filesystem>
#include <span>

#include "tests/peers/comparison.h"

namespace scb {

/// A gnuplot script that draws `peers.png` where it runs: how many times as quick as FCL every peer
/// is on every scene, cold and warm, on a logarithmic scale; its data is in the script.
std::string plot_script(std::span<const PeerKind> kinds, std::span<const SceneComparison> scenes);

/// Runs gnuplot on the script `name` of the folder. Throws OutputError where it cannot be run or
/// fails.
void run_gnuplot(const std::filesystem::path& folder, const std::string& name);

}  // namespace scb
