#include "core/geometry/mesh_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "core/base/statistics.h"
#include "core/geometry/mesh_parts.h"
#include "core/geometry/triangle_pair.h"

namespace scb {
namespace {

constexpr double least_slender = 16;

std::size_t class_of(double slenderness) {
    std::size_t found = 0;
    for (double limit = 4; found + 1 < slenderness_classes && slenderness >= limit; limit *= 4)
        ++found;
    return found;
}

}  // namespace

TriangleSize triangle_size(const TriangleCorners& t) {
    const double longest =
        std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    const double doubled_area = std::sqrt(squared_norm(cross(t[1] - t[0], t[2] - t[0])));
    return {longest,
            ratio(longest * longest, doubled_area, std::numeric_limits<double>::infinity())};
}

bool is_slender(const TriangleCorners& corners) {
    return !is_degenerate(corners) && triangle_size(corners).slenderness >= least_slender;
}

std::size_t MeshFacts::slender() const {
    return std::accumulate(slenderness.begin() + 2, slenderness.end(), std::size_t{0});
}

MeshFacts mesh_facts(const Mesh& mesh) {
    MeshFacts facts;
    facts.box = bounding_box(mesh);
    facts.triangles = mesh.triangles.size();
    std::vector<Triangle> placed = joined_triangles(mesh);
    std::vector<double> all;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const TriangleCorners at = corners(mesh, i);
        if (is_degenerate(at)) {
            ++facts.degenerate;
            continue;
        }
        const auto [side, slender] = triangle_size(at);
        all.push_back(slender);
        ++facts.slenderness[class_of(slender)];
        if (slender >= least_slender && side > facts.longest_slender_side) {
            facts.longest_slender_side = side;
            facts.longest_slender = i;
        }
    }
    if (!all.empty()) {
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
        std::nth_element(all.begin(), middle, all.end());
        facts.median_slenderness = *middle;
    }
    facts.components = mesh_parts(placed, mesh.vertices.size()).count;

    // Sorting puts duplicates side by side; only the edges of the first count.
    for (Triangle& t : placed) std::sort(t.begin(), t.end());
    std::sort(placed.begin(), placed.end());
    const auto end = std::unique(placed.begin(), placed.end());
    facts.duplicates = static_cast<std::size_t>(placed.end() - end);
    placed.erase(end, placed.end());
    // A triangle with two equal corners would have one edge twice. Triangles with collinear corners
    // stay: they close a mesh whose neighbors divide an edge in other places.
    std::erase_if(placed, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2]; });
    for (const std::uint32_t uses : edge_uses(placed)) {
        facts.open_edges += uses == 1;
        facts.crowded_edges += uses > 2;
    }
    return facts;
}

std::vector<std::uint32_t> duplicate_triangles(const Mesh& mesh) {
    std::vector<Triangle> placed = joined_triangles(mesh);
    std::vector<std::pair<Triangle, std::uint32_t>> sorted;
    for (std::uint32_t i = 0; i < placed.size(); ++i) {
        std::sort(placed[i].begin(), placed[i].end());
        sorted.emplace_back(placed[i], i);
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::uint32_t> duplicates;
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (sorted[i].first == sorted[i - 1].first) duplicates.push_back(sorted[i].second);
    std::sort(duplicates.begin(), duplicates.end());
    return duplicates;
}

Box bounding_box(const Mesh& mesh, const Pose& pose) {
    Box box;
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle) box.add(transform_point(pose, mesh.vertices[v]));
    return box;
}

Vec3 gap_between(const Box& x, const Box& y) {
    return (y.lower - x.upper).cwiseMax(0) + (y.upper - x.lower).cwiseMin(0);
}

}  // namespace scb
