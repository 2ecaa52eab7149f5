#include "core/analysis/waste_causes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/statistics.h"
#include "scb/triangle_overlap.h"

namespace scb {
namespace {

constexpr double cosine_of_ten_degrees = 0.98480775301220806;
constexpr double unequal_sizes = 10;

/// The unit normal, or zero for a degenerate triangle. Scales first: powers of lengths may
/// overflow.
Vec3 normal_of(const Mesh& mesh, std::uint32_t triangle) {
    const TriangleCorners t = corners(mesh, triangle);
    Vec3 u = t[1] - t[0], v = t[2] - t[0];
    for (Vec3* edge : {&u, &v}) {
        const double longest = edge->cwiseAbs().maxCoeff();
        if (longest > 0) *edge /= longest;
    }
    const Vec3 normal = cross(u, v);
    const double length = std::sqrt(squared_norm(normal));
    return length > 0 ? Vec3(normal / length) : Vec3(Vec3::Zero());
}

BodyCauses body_causes(const QueriedBody& body, const MeshFacts& of_mesh) {
    BodyCauses causes{of_mesh, body.depth};
    const MeshFacts& facts = causes.facts;
    causes.slender = 20 * facts.slender() >= facts.triangles;
    causes.duplicated = 100 * facts.duplicates >= facts.triangles;
    causes.soup = facts.components > 1 && 10 * facts.components >= facts.triangles;
    causes.deep = causes.depth > 2 * static_cast<int>(std::bit_width(facts.triangles));
    std::vector<std::uint32_t> duplicates;
    if (causes.duplicated) duplicates = duplicate_triangles(body.mesh);
    for (const TestedTriangle& one : body.tested) {
        if (is_slender(corners(body.mesh, one.triangle))) causes.slender_tests += one.items;
        if (std::binary_search(duplicates.begin(), duplicates.end(), one.triangle))
            causes.duplicate_tests += one.items;
    }
    return causes;
}

}  // namespace

VainTests& VainTests::operator+=(const VainTests& other) {
    tests += other.tests;
    parallel += other.parallel;
    return *this;
}

VainTests vain_tests(const Mesh& mesh_a, const Mesh& mesh_b, const QueryTrace& frame) {
    VainTests vain;
    for (const ItemStep& test : frame.steps.items) {
        if (test.hit || test.neighbors) continue;
        const Vec3 n = normal_of(mesh_a, test.items.a),
                   m = transform_direction(frame.b_to_a, normal_of(mesh_b, test.items.b));
        ++vain.tests;
        vain.parallel += std::abs(dot(n, m)) >= cosine_of_ten_degrees;
    }
    return vain;
}

WasteCauses waste_causes(const QueriedBody& a, const QueriedBody& b, const VainTests& vain) {
    const bool alike = &a.mesh == &b.mesh;
    const MeshFacts of_a = mesh_facts(a.mesh);
    WasteCauses causes{
        {body_causes(a, of_a), body_causes(b, alike ? of_a : mesh_facts(b.mesh))}, alike, vain};
    const auto diagonal = [](const BodyCauses& body) {
        return (body.facts.box.upper - body.facts.box.lower).norm();
    };
    causes.larger = ratio(diagonal(causes.bodies[0]), diagonal(causes.bodies[1]),
                          std::numeric_limits<double>::infinity());
    causes.unequal = causes.larger >= unequal_sizes || causes.larger * unequal_sizes <= 1;
    causes.parallel = vain.tests > 0 && 2 * vain.parallel >= vain.tests;
    return causes;
}

}  // namespace scb
