#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/figures/query_body.h"
#include "render/figures/scene_figure.h"

namespace scb::render {

/// A node or a triangle of one of the bodies of a picture.
struct BodyPart {
    std::size_t body = 0;  ///< index of ProblemParts::bodies
    std::uint32_t index = 0;
};

/// The parts of one or two bodies that a problem concerns.
struct ProblemParts {
    std::vector<QueryBody> bodies;
    std::size_t first_side = 0;   ///< 1 if the only body is drawn as the second one
    std::vector<BodyPart> nodes;  ///< nodes with volumes
    std::vector<BodyPart> triangles;
};

/// The nodes' volumes, translucent, and hatched for the second body; the triangles in the bodies'
/// colors; behind them, faint, the meshes.
Pane problem_pane(const ProblemParts& parts, const Theme& theme);

/// The region that a camera must show: these volumes and triangles, and a little around them.
std::vector<AnyVolume> problem_region(const ProblemParts& parts);

/// The meaning of the colors.
std::vector<PanelItem> problem_keys(const ProblemParts& parts, const Theme& theme);

}  // namespace scb::render
