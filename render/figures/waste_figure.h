#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/analysis/trace.h"
#include "core/analysis/wasted_cost.h"
#include "render/figures/query_body.h"
#include "render/figures/scene_figure.h"
#include "render/figures/seeing_direction.h"

namespace scb::render {

/// A triangle of A (`side` 0) or B (1) that is outlined.
struct MarkedTriangle {
    std::size_t side = 0;
    std::uint32_t triangle = 0;
};

/// Where the wasted tests of a query are.
struct Waste {
    /// Per body and triangle, see wasted_cost. In a self query all belongs to A.
    std::array<std::vector<double>, 2> cost;
    double sum = 0;                      ///< of both bodies
    double scale_end = 0;                ///< a round number that no cost exceeds; 0 without waste
    std::vector<MarkedTriangle> marked;  ///< the most costly first
};

Waste waste_of(const QueryBodies& bodies, const TraceHeader& header, const QueryTrace& frame,
               const TestCosts& costs, std::vector<MarkedTriangle> marked);

/// Both bodies, pale; triangles with much waste in colors by their cost, which shine through a
/// body in front of them; the marked triangles outlined.
Pane waste_pane(const QueryBodies& bodies, const Waste& waste, const Theme& theme);

/// For seeing_direction: the triangles of each body with the most waste. The score is the product
/// of the numbers of their visible pixels, so that both bodies are to be seen.
Subject waste_subject(const QueryBodies& bodies, const Waste& waste);

/// The corners of the triangles of each body with the most waste, in the world.
std::vector<AnyVolume> waste_region(const QueryBodies& bodies, const Waste& waste);

/// The numbers of marked triangles, at their places.
std::vector<SceneLabel> waste_labels(const QueryBodies& bodies, const Waste& waste);

std::vector<PanelItem> waste_panel(const QueryBodies& bodies, const QueryTrace& frame,
                                   const Waste& waste, const Theme& theme);

}  // namespace scb::render
