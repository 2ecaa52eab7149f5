#pragma once

#include <vector>

#include "core/analysis/trace.h"
#include "render/figures/query_body.h"

namespace scb::render {

/// The areas in which triangles of a query's pairs lie on each other, in the world, in order of the
/// pairs. The id of each is the index of its pair.
std::vector<Area> contact_areas(const QueryBodies& bodies, const QueryTrace& frame);

/// The edges of areas that no other area in the same plane shares, in order of the areas, with
/// their ids.
std::vector<Segment> outlines_of(const std::vector<Area>& areas);

}  // namespace scb::render
