#pragma once

#include <vector>

#include "core/analysis/trace.h"
#include "core/base/parallel_for.h"
#include "render/figures/query_body.h"
#include "scb/triangle_overlap.h"

namespace scb::render {

/// For each pair of a query, `find` of the corners of both triangles in A's frame, where they were
/// tested.
template <class Found, class Find>
std::vector<Found> of_pairs(const QueryBodies& bodies, const QueryTrace& frame, Find find) {
    constexpr std::size_t pairs_in_block = 256;
    const std::vector<IndexPair>& pairs = frame.found.pairs;
    std::vector<Found> found(pairs.size());
    parallel_blocks(
        processor_count(), pairs.size(),
        [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i)
                found[i] =
                    find(corners(*bodies[0].mesh, pairs[i].a),
                         transform_corners(frame.b_to_a, corners(*bodies[1].mesh, pairs[i].b)));
        },
        pairs_in_block);
    return found;
}

/// The areas in which triangles of a query's pairs lie on each other, in the world, in order of the
/// pairs. The id of each is the index of its pair.
std::vector<Area> contact_areas(const QueryBodies& bodies, const QueryTrace& frame);

/// The edges of areas that no other area in the same plane shares, in order of the areas, with
/// their ids.
std::vector<Segment> outlines_of(const std::vector<Area>& areas);

}  // namespace scb::render
