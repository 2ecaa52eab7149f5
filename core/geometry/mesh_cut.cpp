#include "core/geometry/mesh_cut.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <numeric>
#include <utility>

namespace scb {
namespace {

/// The two vertices of a side, the lower index first.
using Side = std::pair<std::uint32_t, std::uint32_t>;

class Cutter {
  public:
    Cutter(const Mesh& mesh, double longest)
        : longest_(longest), joined_(joined_vertices(mesh)), result_{mesh, {}, 0, 0} {
        result_.origin.resize(mesh.triangles.size());
        std::iota(result_.origin.begin(), result_.origin.end(), 0u);
    }

    /// The seeds, and all triangles that share long sides with them, ascending.
    std::vector<std::uint32_t> reached_from(std::span<const std::uint32_t> seeds) const {
        const std::vector<Triangle>& triangles = result_.mesh.triangles;
        std::vector<std::pair<Side, std::uint32_t>> long_sides;
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            for (int i = 0; i < 3; ++i)
                if (is_long(triangles[t], i)) long_sides.emplace_back(side(triangles[t], i), t);
        std::sort(long_sides.begin(), long_sides.end());
        std::vector<char> reached(triangles.size());
        std::vector<std::uint32_t> found;
        const auto reach = [&](std::uint32_t t) {
            if (!reached[t]) found.push_back(t);
            reached[t] = 1;
        };
        if (seeds.empty())
            for (const auto& [of, t] : long_sides) reach(t);
        for (const std::uint32_t t : seeds) reach(t);
        for (std::size_t next = 0; next < found.size(); ++next) {
            const Triangle triangle = triangles[found[next]];
            for (int i = 0; i < 3; ++i) {
                if (!is_long(triangle, i)) continue;
                const Side of = side(triangle, i);
                for (auto at = std::lower_bound(long_sides.begin(), long_sides.end(),
                                                std::pair(of, std::uint32_t{0}));
                     at != long_sides.end() && at->first == of; ++at)
                    reach(at->second);
            }
        }
        std::sort(found.begin(), found.end());
        return found;
    }

    /// False if there would be more pieces than `most`.
    bool cut(std::uint32_t triangle, std::size_t most) {
        std::vector<Triangle> left = {result_.mesh.triangles[triangle]};
        std::size_t pieces = 0;
        while (!left.empty()) {
            const Triangle piece = left.back();
            left.pop_back();
            const int i = longest_side(piece);
            if (is_long(piece, i) && has_middle(piece, i)) {
                const std::uint32_t middle = middle_of(piece, i);
                const std::uint32_t from = corner(piece, i), to = corner(piece, i + 1),
                                    opposite = corner(piece, i + 2);
                left.push_back({middle, to, opposite});
                left.push_back({from, middle, opposite});
                continue;
            }
            if (result_.pieces + ++pieces > most) return false;
            if (pieces == 1) {
                result_.mesh.triangles[triangle] = piece;
            } else {
                result_.mesh.triangles.push_back(piece);
                result_.origin.push_back(triangle);
            }
        }
        if (pieces > 1) {
            ++result_.cut;
            result_.pieces += pieces;
        }
        return true;
    }

    CutMesh result() && { return std::move(result_); }

  private:
    static std::uint32_t corner(const Triangle& t, int i) {
        return t[static_cast<std::size_t>(i % 3)];
    }
    Side side(const Triangle& t, int i) const {
        const std::uint32_t p = joined_[corner(t, i)], q = joined_[corner(t, i + 1)];
        return {std::min(p, q), std::max(p, q)};
    }
    /// Depends on the two points alone, in any order, so neighbors agree.
    double length(const Triangle& t, int i) const {
        return (result_.mesh.vertices[corner(t, i)] - result_.mesh.vertices[corner(t, i + 1)])
            .norm();
    }
    bool is_long(const Triangle& t, int i) const { return length(t, i) > longest_; }
    /// Whether the midpoint of a side, rounded, is neither of its ends.
    bool has_middle(const Triangle& t, int i) const {
        const Vec3 &from = result_.mesh.vertices[corner(t, i)],
                   &to = result_.mesh.vertices[corner(t, i + 1)], middle = (from + to) / 2;
        return middle != from && middle != to;
    }
    int longest_side(const Triangle& t) const {
        int found = 0;
        for (const int i : {1, 2})
            if (length(t, i) > length(t, found)) found = i;
        return found;
    }

    /// The vertex in the middle of a side, one for all triangles with this side.
    std::uint32_t middle_of(const Triangle& t, int i) {
        const auto [at, is_new] = middles_.try_emplace(
            side(t, i), static_cast<std::uint32_t>(result_.mesh.vertices.size()));
        if (is_new) {
            std::vector<Vec3>& vertices = result_.mesh.vertices;
            const Vec3 middle = (vertices[corner(t, i)] + vertices[corner(t, i + 1)]) / 2;
            joined_.push_back(at->second);
            vertices.push_back(middle);
        }
        return at->second;
    }

    double longest_;
    std::vector<std::uint32_t> joined_;  // per vertex, see joined_vertices
    CutMesh result_;
    std::map<Side, std::uint32_t> middles_;
};

}  // namespace

std::optional<CutMesh> cut_triangles(const Mesh& mesh, std::span<const std::uint32_t> seeds,
                                     double longest, std::size_t most_pieces) {
    assert(longest > 0 && "pieces have an extent");
    Cutter cutter(mesh, longest);
    for (const std::uint32_t triangle : cutter.reached_from(seeds))
        if (!cutter.cut(triangle, most_pieces)) return std::nullopt;
    return std::move(cutter).result();
}

}  // namespace scb
