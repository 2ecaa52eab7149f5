// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_DOUBLE_DISTANCE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_DOUBLE_DISTANCE_INL_H_
#undef SCB_CORE_DOUBLE_DISTANCE_INL_H_
#else
#define SCB_CORE_DOUBLE_DISTANCE_INL_H_
#endif

#include <algorithm>
#include <span>

#include "core/packed/double_pairs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

// triangle_distance in lanes, for triangles that do not intersect. Each operation is the one of
// triangle_distance.cpp, in the same order, so that distances have the same bits. Points are left
// out, and so is the choice between features of equal distances.

HWY_INLINE Doubles3 times(Doubles share, Doubles3 v) {
    return {share * v.x, share * v.y, share * v.z};
}
HWY_INLINE Doubles squared_between(Doubles3 p, Doubles3 q) { return dot(p - q, p - q); }
HWY_INLINE DoubleMask is_positive(Doubles x) { return Doubles::all(0) < x; }
HWY_INLINE DoubleMask is_inside(Doubles share) {
    return is_positive(share) & (share < Doubles::all(1));
}
HWY_INLINE Doubles3 choose(DoubleMask mask, Doubles3 yes, Doubles3 no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

/// Corners in the order of their coordinates.
struct OrderedCorners {
    Doubles3 corner[3];

    HWY_INLINE OrderedCorners(Doubles3 a, Doubles3 b, Doubles3 c) : corner{a, b, c} {
        order(0, 1);
        order(1, 2);
        order(0, 1);
    }

  private:
    HWY_INLINE void order(int i, int j) {
        const Doubles3 p = corner[i], q = corner[j];
        const DoubleMask turned =
            (q.x < p.x) | ((q.x == p.x) & ((q.y < p.y) | ((q.y == p.y) & (q.z < p.z))));
        corner[i] = choose(turned, q, p);
        corner[j] = choose(turned, p, q);
    }
};

struct DoubleEdge {
    Doubles3 from, along;
    Doubles squared_length;

    HWY_INLINE DoubleEdge(Doubles3 first, Doubles3 last) : DoubleEdge(first, last - first, 0) {}
    HWY_INLINE Doubles3 at(Doubles share) const { return from + times(share, along); }
    HWY_INLINE Doubles nearest(Doubles3 point) const {
        const Doubles share = dot(point - from, along) / squared_length;
        return share + dot(point - at(share), along) / squared_length;
    }

  private:
    HWY_INLINE DoubleEdge(Doubles3 first, Doubles3 vector, int)
        : from(first), along(vector), squared_length(dot(vector, vector)) {}
};

/// The least squared distance of features.
struct LeastSquared {
    Doubles squared;

    HWY_INLINE LeastSquared() : squared(Doubles::all(HUGE_VAL)) {}
    HWY_INLINE void take(Doubles other, DoubleMask valid) {
        squared = min(squared, select(valid, other, Doubles::all(HUGE_VAL)));
    }
    HWY_INLINE void take(Doubles3 p, Doubles3 q) { squared = min(squared, squared_between(p, q)); }
    HWY_INLINE void take(Doubles3 point, const DoubleEdge& edge) {
        const Doubles share = edge.nearest(point);
        take(squared_between(point, edge.at(share)),
             is_inside(share) & is_positive(edge.squared_length));
    }
    HWY_INLINE void take(const DoubleEdge& a, const DoubleEdge& b) {
        const Doubles3 normal = cross(a.along, b.along);
        const Doubles of_normal = dot(normal, normal),
                      share = dot(normal, cross(b.along, a.from - b.from)) / of_normal,
                      of_b = b.nearest(a.at(share)), of_a = a.nearest(b.at(of_b));
        take(squared_between(a.at(of_a), b.at(of_b)),
             is_positive(of_normal) & is_inside(share) & is_inside(of_b) & is_inside(of_a));
    }
};

class DoubleFace {
  public:
    HWY_INLINE DoubleFace(const OrderedCorners& t, const DoubleEdge (&edges)[3])
        : DoubleFace(edges[0].squared_length < edges[1].squared_length, t, edges) {}

    HWY_INLINE void take(Doubles3 point, LeastSquared& least) const {
        Doubles3 rest = point - from_;
        Doubles of_apex = Doubles::all(0), of_end = of_apex;
        for (int k = 0; k < 2; ++k) {
            const Doubles apex = dot(rest, height_) / squared_height_;
            of_end = of_end + (dot(rest, along_) / squared_length_ - apex * foot_);
            of_apex = of_apex + apex;
            rest = point - at(of_apex, of_end);
        }
        const Doubles of_start = Doubles::all(1) - of_apex - of_end;
        least.take(squared_between(point, at(of_apex, of_end)),
                   is_positive(of_apex) & is_positive(of_start) & is_positive(of_end) &
                       is_positive(squared_height_) & is_positive(squared_length_));
    }

  private:
    HWY_INLINE DoubleFace(DoubleMask second, const OrderedCorners& t, const DoubleEdge (&edges)[3])
        : DoubleFace(second, select(second, edges[1].squared_length, edges[0].squared_length), t,
                     edges) {}
    HWY_INLINE DoubleFace(DoubleMask second, Doubles longer, const OrderedCorners& t,
                          const DoubleEdge (&edges)[3])
        : DoubleFace(choose(longer < edges[2].squared_length, edges[2].from, edges[0].from),
                     choose(longer < edges[2].squared_length, t.corner[0],
                            choose(second, t.corner[1], t.corner[2])),
                     choose(longer < edges[2].squared_length, edges[2].along,
                            choose(second, edges[1].along, edges[0].along)),
                     max(longer, edges[2].squared_length)) {}
    HWY_INLINE DoubleFace(Doubles3 from, Doubles3 apex, Doubles3 along, Doubles squared_length)
        : from_(from),
          to_apex_(apex - from),
          along_(along),
          height_(to_apex_),
          squared_length_(squared_length),
          foot_(dot(to_apex_, along) / squared_length),
          squared_height_(foot_) {
        for (int k = 0; k < 2; ++k)
            height_ = height_ - times(dot(height_, along_) / squared_length_, along_);
        squared_height_ = dot(height_, height_);
    }
    HWY_INLINE Doubles3 at(Doubles of_apex, Doubles of_end) const {
        return from_ + times(of_apex, to_apex_) + times(of_end, along_);
    }

    Doubles3 from_, to_apex_, along_, height_;
    Doubles squared_length_, foot_, squared_height_;
};

HWY_INLINE Doubles distance_apart(const OrderedCorners& a, const OrderedCorners& b) {
    const auto edge = [](const OrderedCorners& t, int i, int j)
                          HWY_ATTR { return DoubleEdge(t.corner[i], t.corner[j]); };
    const DoubleEdge edges_a[3] = {edge(a, 0, 1), edge(a, 0, 2), edge(a, 1, 2)},
                     edges_b[3] = {edge(b, 0, 1), edge(b, 0, 2), edge(b, 1, 2)};
    LeastSquared least;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            least.take(a.corner[i], b.corner[j]);
            least.take(a.corner[i], edges_b[j]);
            least.take(b.corner[j], edges_a[i]);
            least.take(edges_a[i], edges_b[j]);
        }
    const DoubleFace face_a(a, edges_a), face_b(b, edges_b);
    for (int i = 0; i < 3; ++i) {
        face_b.take(a.corner[i], least);
        face_a.take(b.corner[i], least);
    }
    return sqrt(least.squared);
}

/// The distances of pairs of triangles that do not intersect: what triangle_distance returns.
inline void distances_apart(const Mesh& a, const Mesh& b, const Pose& b_to_a,
                            std::span<const IndexPair> pairs, double* distances) {
    TriangleRows of_a, of_b;
    for (std::size_t first = 0; first < pairs.size(); first += double_lanes) {
        const std::size_t count = std::min(double_lanes, pairs.size() - first);
        for (std::size_t k = 0; k < double_lanes; ++k) {
            const IndexPair& pair = pairs[first + std::min(k, count - 1)];
            of_a.set(k, a, pair.a);
            of_b.set(k, b, pair.b);
        }
        const OrderedCorners p(of_a.corner(0), of_a.corner(1), of_a.corner(2)),
            q(transformed(b_to_a, of_b.corner(0)), transformed(b_to_a, of_b.corner(1)),
              transformed(b_to_a, of_b.corner(2)));
        double found[double_lanes];
        distance_apart(p, q).store(found);
        std::copy_n(found, count, distances + first);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
