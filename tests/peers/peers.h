#pragma once

#include <span>

#include "tests/peers/peer.h"

namespace scb {

/// The name of the peer that all pair sets are compared with: this project's reference traversal.
inline constexpr const char* reference_name = "reference";

/// The name of the peer that all times are compared with.
inline constexpr const char* baseline_name = "fcl";

/// The peers that take part where none are named, those that this program was built with.
std::vector<std::string> default_peers();

/// The peers of these names: "reference", the packed layouts ("float8", "quantized8", ..., perhaps
/// with "-cost" and "-scb2" behind them, in that order), which share a query among so many threads,
/// and the libraries. Throws InputError for a name that is
/// unknown or given twice, and for a library that this program was built without.
std::vector<PeerKind> peers_of(std::span<const std::string> names, int threads);

}  // namespace scb
