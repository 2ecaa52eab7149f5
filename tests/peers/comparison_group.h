#pragma once

#include <span>

#include "tests/peers/comparison.h"

namespace scb {

/// Scenes that have tables, and a row of the plot, of their own.
struct ComparisonGroup {
    std::string title;  ///< before the titles of tables and panels; empty for all other scenes
    std::vector<SceneComparison> scenes;
};

/// Adds the scene to its group, which is made where it is the first: CAD scenes have one,
/// scenes of parts that lie on each other another, and all others, of Table 3 and of files, a
/// third, in the order of their first scenes.
void add_to_group(std::vector<ComparisonGroup>& groups, SceneComparison scene);

/// Whether the peer at this place among the peers found the reference's pairs in all scenes.
bool finds_the_same(std::span<const ComparisonGroup> groups, std::size_t peer);

}  // namespace scb
