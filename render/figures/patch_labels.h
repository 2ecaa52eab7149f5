#pragma once

#include <span>
#include <vector>

#include "core/analysis/trace.h"
#include "core/distance/contact_patches.h"
#include "render/figures/query_body.h"
#include "render/figures/scene_figure.h"

namespace scb::render {

/// The patches of a query's pairs of triangles, the largest first.
std::vector<ContactPatch> patches_of(const QueryBodies& bodies, const TraceHeader& header,
                                     const QueryTrace& frame);

/// The numbers of the largest patches, from 1, each where its contact is nearest to the eye, but
/// away from the labels before it. `contact`: of contact_segments.
std::vector<SceneLabel> patch_labels(std::span<const ContactPatch> patches,
                                     const QueryBodies& bodies, std::span<const Segment> contact,
                                     const Camera& camera, const Theme& theme);

/// How many patches there are, and how many pairs the largest ones have.
std::vector<PanelItem> patch_rows(std::span<const ContactPatch> patches);

}  // namespace scb::render
