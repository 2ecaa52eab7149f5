#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/analysis/tested_triangles.h"
#include "core/analysis/trace.h"
#include "core/geometry/mesh_facts.h"

namespace scb {

/// Tests of two triangles that do not intersect.
struct VainTests {
    std::uint64_t tests = 0;
    std::uint64_t parallel = 0;  ///< of these, tests of planes less than ten degrees from parallel

    VainTests& operator+=(const VainTests& other);
};

/// The vain tests of one query. Degenerate triangles are parallel to none.
VainTests vain_tests(const Mesh& mesh_a, const Mesh& mesh_b, const QueryTrace& frame);

/// Properties of a body that are known to make volumes loose, or the tree poor.
struct BodyCauses {
    MeshFacts facts;
    int depth = 0;            ///< of its hierarchy
    bool slender = false;     ///< at least 5 % of the triangles have a slenderness of 16 or more
    bool duplicated = false;  ///< at least 1 % of the triangles are duplicates
    bool soup = false;        ///< several parts, at least one per ten triangles
    bool deep = false;        ///< deeper than twice the base-2 logarithm of the number of triangles
    /// Triangle tests of the body's slender triangles, and of its duplicates. In a self query, a
    /// test of two of these counts twice.
    std::uint64_t slender_tests = 0, duplicate_tests = 0;
};

/// Why tests in queries of two bodies are wasted.
struct WasteCauses {
    std::array<BodyCauses, 2> bodies;
    bool alike = false;  ///< both have the same mesh
    VainTests vain;
    double larger = 1;      ///< diagonal of A's box over B's diagonal; 0 or infinity for points
    bool unequal = false;   ///< one is ten times the other, or more
    bool parallel = false;  ///< at least half of the vain tests are of nearly parallel triangles
};

/// A body of queries: its mesh, the depth of its hierarchy, and the tests of its triangles.
struct QueriedBody {
    const Mesh& mesh;
    int depth = 0;
    std::span<const TestedTriangle> tested{};
};

/// The bodies are alike if they have the same mesh object.
WasteCauses waste_causes(const QueriedBody& a, const QueriedBody& b, const VainTests& vain);

}  // namespace scb
