#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/geometry/orientation.h"

namespace scb {
namespace {

using HullIndex = std::uint32_t;

/// A triangle of the hull, seen counterclockwise from outside.
struct HullFacet {
    std::array<HullIndex, 3> corners;
    std::array<HullIndex, 3> neighbors;  ///< across the edges from corner i to corner i + 1
    PlaneFilter plane;
    std::vector<HullIndex> outside;  ///< points outside of it that are no vertices yet
    bool removed = false;
};

class Quickhull {
  public:
    explicit Quickhull(std::span<const Vec3> points) : points_(points), facet_at_(points.size()) {}

    ConvexHull run() {
        if (!begin()) {
            ConvexHull flat;
            flat.vertices.resize(points_.size());
            std::iota(flat.vertices.begin(), flat.vertices.end(), HullIndex{0});
            return flat;
        }
        // New facets are appended, so this loop reaches them.
        for (HullIndex f = 0; f < facets_.size(); ++f)
            if (!facets_[f].removed && !facets_[f].outside.empty()) add_farthest(f);
        return result();
    }

  private:
    /// The first index with the largest value.
    template <class Value>
    HullIndex farthest(Value&& value) const {
        HullIndex best = 0;
        double most = -1;
        for (HullIndex i = 0; i < points_.size(); ++i)
            if (const double v = value(points_[i]); v > most) {
                most = v;
                best = i;
            }
        return best;
    }

    int side(const HullFacet& facet, HullIndex point) const {
        const int certain = facet.plane.side(points_[point]);
        if (certain != 0) return certain;
        const auto [a, b, c] = facet.corners;
        return orient3d_exact(points_[a], points_[b], points_[c], points_[point]);
    }

    HullIndex add_facet(HullIndex a, HullIndex b, HullIndex c) {
        facets_.push_back({{a, b, c}, {}, PlaneFilter(points_[a], points_[b], points_[c]), {}});
        return static_cast<HullIndex>(facets_.size() - 1);
    }

    /// Begins with the tetrahedron of four points that are in no plane. False if all points are in
    /// one plane.
    bool begin() {
        if (points_.size() < 4) return false;
        const Vec3 first = points_[0];
        const HullIndex a = farthest([&](const Vec3& p) { return squared_norm(p - first); });
        const Vec3 pa = points_[a];
        const HullIndex b = farthest([&](const Vec3& p) { return squared_norm(p - pa); });
        const Vec3 along = points_[b] - pa;
        const HullIndex c =
            farthest([&](const Vec3& p) { return squared_norm(cross(along, p - pa)); });
        const Vec3 normal = cross(along, points_[c] - pa);
        HullIndex d = farthest([&](const Vec3& p) { return std::abs(dot(normal, p - pa)); });
        // Rounding may have chosen a point in the plane of these three.
        for (HullIndex i = 0; i < points_.size() && side_of(a, b, c, d) == 0; ++i) d = i;
        const int up = side_of(a, b, c, d);
        if (up == 0) return false;
        const std::array<HullIndex, 3> base = up < 0 ? std::array{a, b, c} : std::array{a, c, b};
        const auto [p, q, r] = base;
        add_facet(p, q, r);
        add_facet(q, p, d);
        add_facet(r, q, d);
        add_facet(p, r, d);
        facets_[0].neighbors = {1, 2, 3};
        facets_[1].neighbors = {0, 3, 2};
        facets_[2].neighbors = {0, 1, 3};
        facets_[3].neighbors = {0, 2, 1};
        for (HullIndex i = 0; i < points_.size(); ++i) hand_out(i, 0);
        return true;
    }

    int side_of(HullIndex a, HullIndex b, HullIndex c, HullIndex d) const {
        return orient3d(points_[a], points_[b], points_[c], points_[d]);
    }

    /// Gives the point to the first facet from `begin` on that it is outside of; to none if it is
    /// inside.
    void hand_out(HullIndex point, HullIndex begin) {
        for (HullIndex f = begin; f < facets_.size(); ++f)
            if (side(facets_[f], point) > 0) {
                facets_[f].outside.push_back(point);
                return;
            }
    }

    void add_farthest(HullIndex facet) {
        const HullFacet& seen = facets_[facet];
        HullIndex apex = seen.outside[0];
        double most = -1;
        for (const HullIndex i : seen.outside)
            if (const double h = dot(seen.plane.normal, points_[i] - seen.plane.origin); h > most) {
                most = h;
                apex = i;
            }
        // The facets visible from the apex are connected. A facet with the apex in its plane is not
        // visible, as from a point slightly further in.
        visible_.assign(1, facet);
        facets_[facet].removed = true;
        const auto first_new = static_cast<HullIndex>(facets_.size());
        horizon_.clear();
        for (std::size_t v = 0; v < visible_.size(); ++v)
            for (std::size_t e = 0; e < 3; ++e) {
                const HullFacet& inner = facets_[visible_[v]];
                const HullIndex outer = inner.neighbors[e];
                if (facets_[outer].removed) continue;
                if (side(facets_[outer], apex) > 0) {
                    facets_[outer].removed = true;
                    visible_.push_back(outer);
                } else {
                    horizon_.push_back({inner.corners[e], inner.corners[(e + 1) % 3], outer});
                }
            }
        for (const auto& [from, to, outer] : horizon_) facet_at_[from] = add_facet(from, to, apex);
        for (const auto& [from, to, outer] : horizon_) {
            const HullIndex own = facet_at_[from], next = facet_at_[to];
            facets_[own].neighbors[0] = outer;
            facets_[own].neighbors[1] = next;
            facets_[next].neighbors[2] = own;
            HullFacet& across = facets_[outer];
            for (std::size_t e = 0; e < 3; ++e)
                if (across.corners[e] == to && across.corners[(e + 1) % 3] == from)
                    across.neighbors[e] = own;
        }
        for (const HullIndex f : visible_) {
            const std::vector<HullIndex> orphans = std::move(facets_[f].outside);
            facets_[f].outside = {};
            for (const HullIndex i : orphans)
                if (i != apex) hand_out(i, first_new);
        }
    }

    ConvexHull result() const {
        ConvexHull hull;
        std::vector<bool> used(points_.size());
        double six_times = 0;
        Vec3 origin;
        bool has_origin = false;
        for (const HullFacet& facet : facets_) {
            if (facet.removed) continue;
            const auto [a, b, c] = facet.corners;
            for (const HullIndex i : facet.corners) used[i] = true;
            if (!has_origin) origin = points_[a];
            has_origin = true;
            six_times += dot(points_[a] - origin, cross(points_[b] - origin, points_[c] - origin));
        }
        for (HullIndex i = 0; i < points_.size(); ++i)
            if (used[i]) hull.vertices.push_back(i);
        hull.volume = std::max(0.0, six_times / 6);
        return hull;
    }

    struct HorizonEdge {
        HullIndex from, to, outer;
    };

    std::span<const Vec3> points_;
    std::vector<HullFacet> facets_;
    std::vector<HullIndex> visible_, facet_at_;
    std::vector<HorizonEdge> horizon_;
};

}  // namespace

ConvexHull convex_hull(std::span<const Vec3> points) { return Quickhull(points).run(); }

}  // namespace scb
