#pragma once

#include <cstdint>

namespace scb {

/// The kinds of queries.
enum class QueryKind : std::uint8_t {
    collide,  ///< the intersecting triangles of two bodies
    self,     ///< the intersecting triangles of one body, see collide_self
};

}  // namespace scb
