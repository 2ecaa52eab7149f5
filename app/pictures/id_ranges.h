#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/study/query_sources.h"

namespace scb::app {

/// Consecutive ids of a picture, for the nodes or triangles of a body, or for pairs.
struct IdRange {
    std::uint32_t first = 1;
    std::size_t count = 0;
};

/// The meanings of the ids of a query's pictures, from 1: the nodes of A and of B, their triangles,
/// and then the other things that a picture shows.
struct IdRanges {
    std::array<IdRange, 2> nodes, triangles;
    std::uint32_t first_free = 1;
};

/// Throws InputError if the bodies have more nodes and triangles than there are ids.
IdRanges id_ranges(const QuerySources& sources);

/// The numbers of all nodes, in the order of their ids, if some nodes have other numbers than their
/// indices. Else empty.
std::vector<std::uint32_t> numbers_by_id(const Tree& tree);

/// The ids of the segments in which the pairs of each query meet, in the order of
/// `scb collide --pairs-out`.
std::vector<IdRange> pair_id_ranges(const IdRanges& ids, const QueryFrames& frames);

/// The meaning of an id of a picture of this frame, as text: "node 412 of A, depth 9, 2 triangles",
/// "triangles 3 and 8 meet", "nothing". `source`: the query in the picture.
std::string id_text(const IdRanges& ids, const QuerySource& source, const QueryFrames& frames,
                    std::uint32_t id);

}  // namespace scb::app
