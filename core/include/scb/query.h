#pragma once

#include <cstdint>

namespace scb {

/// The kinds of queries.
enum class QueryKind : std::uint8_t {
    collide,  ///< the triangles of two bodies that intersect
    self,     ///< the triangles of one body that intersect, see collide_self
};

}  // namespace scb
