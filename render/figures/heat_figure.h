#pragma once

#include <array>
#include <optional>

#include "core/analysis/trace.h"
#include "core/analysis/triangle_heat.h"
#include "core/base/enum_names.h"
#include "render/figures/query_body.h"
#include "render/figures/scene_figure.h"
#include "render/plots/plot_axis.h"

namespace scb::render {

inline constexpr EnumNames<HeatOf, 3> heat_names = {"volumes", "triangles", "wasted"};

/// The number of tests of each triangle of both bodies, and the scale of its colors.
struct Heat {
    HeatOf of = HeatOf::volumes;
    std::array<std::vector<std::uint32_t>, 2> counts;
    std::uint32_t most = 0;    ///< of both bodies
    std::uint64_t wasted = 0;  ///< wasted volume tests of the query, if `of` selects these
    PlotAxis scale;            ///< logarithmic, with a place for 0
};

/// `scale_end`: the count at the upper end of the scale; else the first number of the form 1, 2 or
/// 5 times a power of ten that no count exceeds, which seldom changes from frame to frame.
/// `wasted`: which tests are, for HeatOf::wasted only.
Heat heat_of(const QueryBodies& bodies, const QueryTrace& frame, HeatOf of,
             std::optional<std::uint32_t> scale_end, const std::vector<bool>& wasted);

/// Both meshes, each triangle in viridis by its count, and B outlined in its color.
Pane heat_pane(const QueryBodies& bodies, const Heat& heat);

/// The scale of its colors.
PanelItem heat_key(const Heat& heat);

/// Its numbers and its scale.
std::vector<PanelItem> heat_panel(const QueryBodies& bodies, const TraceHeader& header,
                                  const QueryTrace& frame, const Heat& heat);

}  // namespace scb::render
