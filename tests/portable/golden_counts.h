#pragma once

#include <string>
#include <string_view>

namespace scb {

/// What queries find and take, as text that must be the same for every compiler, build type and
/// CPU: for some frames of the built-in scenes that need no mesh files, after a comment that
/// explains them, the lines
///
///     SCENE MODEL mesh: vertices, triangles, and the hash of all coordinates and indices
///     SCENE MODEL KIND: nodes, and the hash of the topology and of all volumes
///     SCENE FRAME KIND [TEST] RULE: N_v, N_p, N_u, depth, triangle pairs and their hash, tests per
///                                   stage
///     SCENE FRAME KIND|LAYOUT distance: N_v, N_p, the triangles, and the hash of the distance
///
/// with every volume kind, overlap test (printed and line8 too) and descent rule. Where the counts
/// of two machines differ, the first line that does tells whether meshes, volumes or queries do.
/// Hashes are FNV-1a of 64 bits over numbers in little-endian order.
std::string golden_counts();

/// Where two such texts differ: the number of the first line that does, and what both have there.
/// Empty where they are equal.
std::string first_difference(std::string_view expected, std::string_view found);

}  // namespace scb
