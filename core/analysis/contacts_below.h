#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/analysis/trace.h"

namespace scb {

/// For each test of volumes, the number of these pairs of triangles below its nodes. Pairs are
/// followed from the root to the last test whose nodes hold them.
std::vector<std::uint64_t> contacts_below(const Topology& a, const Topology& b, QueryKind kind,
                                          const Steps& steps, std::span<const IndexPair> contacts);

}  // namespace scb
