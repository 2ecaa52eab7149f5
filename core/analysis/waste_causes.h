#pragma once

#include <array>
#include <cstdint>

#include "core/analysis/trace.h"
#include "core/geometry/mesh_facts.h"

namespace scb {

/// Tests of two triangles that do not intersect.
struct VainTests {
    std::uint64_t tests = 0;
    std::uint64_t parallel = 0;  ///< of these, those of planes less than ten degrees from parallel

    VainTests& operator+=(const VainTests& other);
};

/// Those of one query. Degenerate triangles are parallel to none.
VainTests vain_tests(const Mesh& mesh_a, const Mesh& mesh_b, const TraceFrame& frame);

/// What of a mesh is known to make volumes loose, or the tree poor.
struct BodyCauses {
    MeshFacts facts;
    int depth = 0;            ///< of its hierarchy
    bool slender = false;     ///< every twentieth triangle or more has a slenderness of 16 and more
    bool duplicated = false;  ///< every hundredth triangle or more is there twice
    bool soup = false;        ///< every tenth triangle or more is a part of its own
    bool deep = false;        ///< deeper than twice the logarithm of the triangles to base 2
};

/// Why the tests of queries of two bodies are wasted.
struct WasteCauses {
    std::array<BodyCauses, 2> bodies;
    bool alike = false;  ///< both have the same mesh
    VainTests vain;
    double larger = 1;      ///< the diagonal of A's box over that of B's; 0 or infinity of points
    bool unequal = false;   ///< one is ten times the other, or more
    bool parallel = false;  ///< half of the vain tests or more are of nearly parallel triangles
};

WasteCauses waste_causes(const Topology& a, const Mesh& mesh_a, const Topology& b,
                         const Mesh& mesh_b, const VainTests& vain);

}  // namespace scb
