#include "core/geometry/mesh_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "core/base/statistics.h"
#include "core/geometry/triangle_pair.h"

namespace scb {
namespace {

/// For each vertex the first one, in lexicographic order of coordinates then of indices, that is at
/// the same place.
std::vector<std::uint32_t> vertices_by_place(const Mesh& mesh) {
    std::vector<bool> used(mesh.vertices.size());
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t) used[v] = true;
    std::vector<std::uint32_t> order;
    for (std::uint32_t v = 0; v < used.size(); ++v)
        if (used[v]) order.push_back(v);
    const auto before = [&](std::uint32_t i, std::uint32_t j) {
        const Vec3 &p = mesh.vertices[i], &q = mesh.vertices[j];
        return precedes(p, q) || (p == q && i < j);
    };
    std::sort(order.begin(), order.end(), before);
    std::vector<std::uint32_t> place(mesh.vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && mesh.vertices[order[i]] == mesh.vertices[order[i - 1]];
        place[order[i]] = same ? place[order[i - 1]] : order[i];
    }
    return place;
}

/// Sets that are joined; each is named by one of its members.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t i, std::uint32_t j) { parent_[find(i)] = find(j); }

  private:
    std::vector<std::uint32_t> parent_;
};

std::size_t count_components(const std::vector<Triangle>& triangles, std::size_t vertices) {
    DisjointSets sets(vertices);
    for (const Triangle& t : triangles) {
        sets.join(t[0], t[1]);
        sets.join(t[0], t[2]);
    }
    std::vector<std::uint32_t> names;
    for (const Triangle& t : triangles) names.push_back(sets.find(t[0]));
    std::sort(names.begin(), names.end());
    return static_cast<std::size_t>(std::unique(names.begin(), names.end()) - names.begin());
}

void count_edges(MeshFacts& facts, const std::vector<Triangle>& triangles) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) edges.push_back(std::minmax(t[k], t[(k + 1) % 3]));
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i;
        while (end < edges.size() && edges[end] == edges[i]) ++end;
        facts.open_edges += end - i == 1;
        facts.crowded_edges += end - i > 2;
        i = end;
    }
}

/// The longest side over the height on it, and the longest side.
std::pair<double, double> slenderness(const TriangleCorners& t) {
    const double longest =
        std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    const double doubled_area = std::sqrt(squared_norm(cross(t[1] - t[0], t[2] - t[0])));
    return {ratio(longest * longest, doubled_area, std::numeric_limits<double>::infinity()),
            longest};
}

std::size_t class_of(double slenderness) {
    std::size_t found = 0;
    for (double limit = 4; found + 1 < slenderness_classes && slenderness >= limit; limit *= 4)
        ++found;
    return found;
}

}  // namespace

std::size_t MeshFacts::slender() const {
    return std::accumulate(slenderness.begin() + 2, slenderness.end(), std::size_t{0});
}

MeshFacts mesh_facts(const Mesh& mesh) {
    MeshFacts facts;
    facts.box = bounding_box(mesh);
    facts.triangles = mesh.triangles.size();
    const std::vector<std::uint32_t> place = vertices_by_place(mesh);
    std::vector<Triangle> placed;
    std::vector<double> all;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const TriangleCorners at = corners(mesh, i);
        placed.push_back({place[t[0]], place[t[1]], place[t[2]]});
        if (is_degenerate(at)) {
            ++facts.degenerate;
            continue;
        }
        const auto [slender, side] = slenderness(at);
        all.push_back(slender);
        ++facts.slenderness[class_of(slender)];
        if (slender >= 16 && side > facts.longest_slender_side) {
            facts.longest_slender_side = side;
            facts.longest_slender = i;
        }
    }
    if (!all.empty()) {
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
        std::nth_element(all.begin(), middle, all.end());
        facts.median_slenderness = *middle;
    }
    facts.components = count_components(placed, mesh.vertices.size());

    // Duplicates side by side, and only the first of them has edges.
    for (Triangle& t : placed) std::sort(t.begin(), t.end());
    std::sort(placed.begin(), placed.end());
    const auto end = std::unique(placed.begin(), placed.end());
    facts.duplicates = static_cast<std::size_t>(placed.end() - end);
    placed.erase(end, placed.end());
    // Its edges would be one edge twice. Collinear corners stay: they close a mesh whose neighbors
    // divide an edge in other places.
    std::erase_if(placed, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2]; });
    count_edges(facts, placed);
    return facts;
}

}  // namespace scb
