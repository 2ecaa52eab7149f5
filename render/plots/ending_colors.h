#pragma once

#include <string>
#include <vector>

#include "core/analysis/ending.h"
#include "render/view/palette.h"

namespace scb::render {

/// Endings that pictures show in one color: each stage of slab cut balls and balls is a group, the
/// 15 axes of boxes are three groups.
struct EndingGroup {
    std::string label;  ///< "slab A, ball B", "faces of A", "triangles apart"
    Rgba8 color;
    std::vector<Stage> endings;
};

/// The largest number of groups.
inline constexpr std::size_t most_groups = 48;

/// The groups of the endings, in their order. Colors mean the same in every picture. Rejections of
/// the volume test are grey (balls), blue (a slab and a ball), violet and olive (second slabs) or
/// green and yellow (a slab and a cylinder, or the last stages). Pairs that passed are purple if
/// the triangles were apart and vermillion if they meet. Pairs that the query left over have the
/// theme's color.
std::vector<EndingGroup> ending_groups(const std::vector<Stage>& endings, const Theme& theme,
                                       const StageTable& stages = {});
/// The groups of the endings that the header's queries can have.
std::vector<EndingGroup> ending_groups(const TraceHeader& header, const Theme& theme);

Rgba8 ending_color(Stage ending, const Theme& theme);

/// The sum of the group's counts.
std::uint64_t count_of(const EndingGroup& group, const EndingCounts& counts);

}  // namespace scb::render
