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

/// What something that went wrong is about: of one body or two.
struct ProblemParts {
    std::vector<QueryBody> bodies;
    std::size_t first_side = 0;   ///< 1 where the only body is drawn as a second one
    std::vector<BodyPart> nodes;  ///< that have volumes
    std::vector<BodyPart> triangles;
};

/// The nodes' volumes, translucent, those of the second body hatched; the triangles in the bodies'
/// colors; behind them, faint, the meshes.
Pane problem_pane(const ProblemParts& parts, const Theme& theme);

/// What a camera has to hold: these volumes and triangles, and a little about them.
std::vector<AnyVolume> problem_region(const ProblemParts& parts);

/// What the colors mean.
std::vector<PanelItem> problem_keys(const ProblemParts& parts, const Theme& theme);

}  // namespace scb::render
