#pragma once

#include <string>
#include <vector>

#include "core/analysis/ending.h"
#include "render/view/palette.h"

namespace scb::render {

/// Endings that a picture shows alike: every stage of slab cut balls and balls for itself, the 15
/// axes of boxes in three groups.
struct EndingGroup {
    std::string label;  ///< "slab A, ball B", "faces of A", "triangles apart"
    Rgba8 color;
    std::vector<Stage> endings;
};

/// There are never more groups than that.
inline constexpr std::size_t most_groups = 48;

/// The groups of the endings, in their order. Colors mean the same in every picture: what the
/// volume test rejected is grey (balls), blue (a slab and a ball), violet and olive (second slabs)
/// or green and yellow (a slab and a cylinder, or what comes last); what it let pass is purple
/// where the triangles were apart and vermillion where they meet. What the query left over has the
/// theme's color.
std::vector<EndingGroup> ending_groups(const std::vector<Stage>& endings, const Theme& theme,
                                       const StageTable& stages = {});
/// The groups of the endings that the header's queries can have.
std::vector<EndingGroup> ending_groups(const TraceHeader& header, const Theme& theme);

Rgba8 ending_color(Stage ending, const Theme& theme);

/// Of the counts, those of the group.
std::uint64_t count_of(const EndingGroup& group, const EndingCounts& counts);

}  // namespace scb::render
