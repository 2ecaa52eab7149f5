#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "app/study/scene_query.h"

namespace scb::app {

/// The first line of a CSV file of pairs of triangles, or of nodes of a level.
std::string pair_lines_header(const SceneQuery& query, bool with_patches = false);
/// A line for each of these pairs of the chosen bodies. `patches`: per pair its patch; empty for
/// lines without patches.
std::string pair_lines(const SceneQuery& query, int frame, std::span<const IndexPair> pairs,
                       std::span<const std::uint32_t> patches = {});

}  // namespace scb::app
