#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/query/query_sources.h"

namespace scb::app {

/// Consecutive ids of a picture, which stand for the nodes or triangles of a body, or for pairs.
struct IdRange {
    std::uint32_t first = 1;
    std::size_t count = 0;
};

/// What the ids of a query's pictures stand for, from 1: the nodes of A and of B, their triangles,
/// and then whatever one picture shows besides.
struct IdRanges {
    std::array<IdRange, 2> nodes, triangles;
    std::uint32_t first_free = 1;
};

/// Throws InputError where the bodies have more nodes and triangles than there are ids.
IdRanges id_ranges(const QuerySources& sources);

/// The numbers of all nodes, in the order of their ids, where these do not follow from the ids:
/// some have other numbers than indices. Else empty.
std::vector<std::uint32_t> numbers_by_id(const Tree& tree);

/// The ids of the segments in which the pairs of each query meet, in the order of
/// `scb collide --pairs-out`.
std::vector<IdRange> pair_id_ranges(const IdRanges& ids, const QueryFrames& frames);

/// What an id of a picture of this frame stands for, as text: "node 412 of A, depth 9, 2
/// triangles", "triangles 3 and 8 meet", "nothing". `query` is the one that the picture shows.
std::string id_text(const IdRanges& ids, const QuerySource& source, const QueryFrames& frames,
                    std::uint32_t id);

}  // namespace scb::app
