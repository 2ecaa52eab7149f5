#include "core/model/node_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "core/explain/exact_overlap.h"
#include "core/model/cut_ball_shape.h"
#include "core/volumes/convex_shape.h"
#include "core/volumes/shape.h"
#include "scb/error.h"
#include "scb/placement.h"

namespace scb {
namespace {

using SharedPolytope = std::shared_ptr<const Polytope>;

ConvexShape shape(const std::monostate&) {
    return {Vec3::Zero(), 0, Mat3::Identity(), [](const Vec3&) { return Vec3(Vec3::Zero()); }, {}};
}

ConvexShape shape(const Obb& box) {
    ConvexShape result{box.center,
                       0,
                       box.axes,
                       [box](const Vec3& d) {
                           Vec3 p = Vec3::Zero();
                           for (int i = 0; i < 3; ++i) {
                               const Vec3 side = box.half[i] * box.axes.col(i);
                               p += dot(side, d) < 0 ? Vec3(-side) : side;
                           }
                           return p;
                       },
                       {}};
    for (int i = 0; i < 3; ++i)
        for (const double sign : {1.0, -1.0})
            result.faces.push_back({sign * box.axes.col(i), box.half[i]});
    return result;
}

ConvexShape shape(const OpenBox& box) {
    // The center is near the finite sides: relative to a center in the middle, rounding would lose
    // their positions.
    Vec3 center = Vec3::Zero(), lower, upper;
    std::vector<FacePlane> faces;
    for (int i = 0; i < 3; ++i) {
        const bool from = std::isfinite(box.lower[i]), to = std::isfinite(box.upper[i]);
        if (from && to)
            center[i] = box.lower[i] + (box.upper[i] - box.lower[i]) / 2;
        else if (from)
            center[i] = box.lower[i] + 1 + std::abs(box.lower[i]);
        else if (to)
            center[i] = box.upper[i] - 1 - std::abs(box.upper[i]);
        lower[i] = from ? box.lower[i] - center[i] : -max_coordinate;
        upper[i] = to ? box.upper[i] - center[i] : max_coordinate;
        if (from) faces.push_back({Vec3(-Vec3::Unit(i)), -lower[i]});
        if (to) faces.push_back({Vec3::Unit(i), upper[i]});
    }
    return {center, 0, Mat3::Identity(),
            [lower, upper](const Vec3& d) {
                return Vec3((d.array() < 0).select(lower.array(), upper.array()));
            },
            std::move(faces)};
}

ConvexShape shape(const Ball& ball) {
    return {ball.center,
            ball.radius,
            Mat3::Identity(),
            [](const Vec3&) { return Vec3(Vec3::Zero()); },
            {}};
}

/// The support point in the direction d is the ball's farthest point or, if a plane cuts that off,
/// the farthest point of the plane's rim.
ConvexShape shape(const Scb& scb) {
    return {scb.c,
            0,
            Mat3::Identity(),
            [scb](const Vec3& d) {
                const double length = std::sqrt(squared_norm(d));
                if (!(length > 0)) return Vec3(scb.n * (scb.e + scb.f) / 2);
                const double along = dot(scb.n, d) / length * scb.r;
                const double height = std::clamp(along, scb.f, scb.e);
                if (height == along) return Vec3(d * (scb.r / length));
                // Subtract twice, since the first difference cancels if d is nearly along n. If d
                // is along n, only rounding is left, and all points of the plane are equally far.
                Vec3 across = d - scb.n * dot(scb.n, d);
                across -= scb.n * dot(scb.n, across);
                double width = std::sqrt(squared_norm(across));
                if (!(width > 1e-15 * length)) width = 0;
                const double rim = std::sqrt(std::max(0.0, (scb.r - height) * (scb.r + height)));
                return Vec3(scb.n * height +
                            (width > 0 ? Vec3(across * (rim / width)) : Vec3(Vec3::Zero())));
            },
            {}};
}

ConvexShape shape(const Scb2& scb) { return shape(Ball{scb.c, scb.r}); }

ConvexShape shape(const SharedPolytope& polytope) {
    return {polytope->center, 0, Mat3::Identity(),
            [polytope](const Vec3& d) {
                const auto less = [&](const Vec3& a, const Vec3& b) {
                    return dot(a, d) < dot(b, d);
                };
                return *std::max_element(polytope->corners.begin(), polytope->corners.end(), less);
            },
            polytope->faces};
}

template <ConvexVolume V>
ConvexShape shape(const V& volume) {
    return shape_of(volume);
}

double beyond(const Slab& slab, const Vec3& p) {
    const double along = dot(slab.n, p);
    return std::max(along - slab.e, slab.f - along);
}

/// Distances; see excess.
struct Excess {
    const Vec3& p;

    double operator()(const std::monostate&) const { return 0; }
    double operator()(const Obb& box) const {
        Vec3 outside;
        for (int i = 0; i < 3; ++i)
            outside[i] = std::abs(dot(Vec3(box.axes.col(i)), Vec3(p - box.center))) - box.half[i];
        const double most = outside.maxCoeff();
        return most <= 0 ? most : std::sqrt(squared_norm(outside.cwiseMax(0)));
    }
    double operator()(const OpenBox& box) const {
        double most = -HUGE_VAL, squares = 0;
        for (int i = 0; i < 3; ++i) {
            const double outside = std::max(box.lower[i] - p[i], p[i] - box.upper[i]);
            most = std::max(most, outside);
            if (outside > 0) squares += outside * outside;
        }
        return most <= 0 ? most : std::sqrt(squares);
    }
    double operator()(const Ball& ball) const {
        return std::sqrt(squared_norm(p - ball.center)) - ball.radius;
    }
    double operator()(const Scb& scb) const {
        const double ball = (*this)(Ball{scb.c, scb.r});
        return std::max(ball, beyond({scb.n, scb.e, scb.f}, p - scb.c));
    }
    double operator()(const Scb2& scb) const {
        double most = (*this)(Ball{scb.c, scb.r});
        for (const Slab& slab : scb.slabs) most = std::max(most, beyond(slab, p - scb.c));
        return most;
    }
    double operator()(const SharedPolytope& polytope) const {
        const Vec3 from_center = p - polytope->center;
        double most = -HUGE_VAL;
        for (const FacePlane& face : polytope->faces)
            most = std::max(most, dot(face.normal, from_center) - face.offset);
        if (!polytope->faces.empty()) return most;
        const ConvexShape point{
            p, 0, Mat3::Identity(), [](const Vec3&) { return Vec3(Vec3::Zero()); }, {}};
        const ContactCertificate found = exact_overlap(shape(polytope), point);
        return found.contact == Contact::disjoint ? found.margin : 0;
    }
    template <class V>  // capsules and rectangle swept spheres
    double operator()(const V& v) const {
        return std::sqrt(squared_distance(v, p)) - v.radius;
    }
};

double reach(const ConvexShape& shape) {
    return std::sqrt(squared_norm(shape.center)) + diameter(shape);
}

template <class V>
ContactCertificate verdict(const V& a, const V& b, const Pose& b_to_a, double tolerance) {
    Placement placed = placement(b_to_a, reach(a), reach(b));
    placed.margin = std::max(placed.margin, tolerance);
    return exact_verdict(a, b, placed);
}

}  // namespace

Obb box_between(const Vec3& lower, const Vec3& upper) {
    return {lower + (upper - lower) / 2, Mat3::Identity(), (upper - lower) / 2};
}

Obb cut_box(const OpenBox& box, const Vec3& lower, const Vec3& upper) {
    Vec3 from = box.lower, to = box.upper;
    for (int i = 0; i < 3; ++i) {
        if (std::isinf(from[i])) from[i] = std::min(to[i], lower[i]);
        if (std::isinf(to[i])) to[i] = std::max(from[i], upper[i]);
    }
    return box_between(from, to);
}

Polytope slabs_polytope(std::span<const double> directions, std::span<const double> bounds) {
    const std::size_t count = directions.size() / 3;
    std::vector<Vec3> normals(count);
    std::vector<std::array<double, 2>> ends(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 d(directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]);
        const double length = std::sqrt(squared_norm(d));
        if (!(length > 0) || !std::isfinite(length))
            throw InputError("its direction " + std::to_string(i) + " is none");
        normals[i] = d / length;
        ends[i] = {bounds[2 * i] / length, bounds[2 * i + 1] / length};
        if (!(ends[i][0] <= ends[i][1]))
            throw InputError("its least value is above the greatest in direction " +
                             std::to_string(i));
    }
    // Three directions far from a common plane bound the polytope, and give a point in its middle.
    std::array<std::size_t, 3> chosen{};
    double widest = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (const double wide = squared_norm(cross(normals[0], normals[i])); wide > widest) {
            widest = wide;
            chosen[1] = i;
        }
    widest = 0;
    const Vec3 across = cross(normals[0], normals[chosen[1]]);
    for (std::size_t i = 0; i < count; ++i)
        if (const double wide = std::abs(dot(across, normals[i])); wide > widest) {
            widest = wide;
            chosen[2] = i;
        }
    if (!(widest > 1e-9)) throw InputError("its directions lie in a plane");
    std::array<Vec3, 3> basis;
    Vec3 middle, half;
    for (std::size_t r = 0; r < 3; ++r) {
        const auto& [lower, upper] = ends[chosen[r]];
        basis[r] = normals[chosen[r]];
        middle[static_cast<int>(r)] = lower + (upper - lower) / 2;
        half[static_cast<int>(r)] = (upper - lower) / 2;
    }
    // By Cramer's rule.
    Mat3 inverse;
    for (std::size_t r = 0; r < 3; ++r)
        inverse.col(static_cast<int>(r)) = cross(basis[(r + 1) % 3], basis[(r + 2) % 3]);
    inverse /= dot(cross(basis[0], basis[1]), basis[2]);
    Polytope result;
    result.center = rotate(inverse, middle);
    const double size = 2 * std::sqrt(squared_norm(rotate(inverse.cwiseAbs(), half)));
    for (std::size_t i = 0; i < count; ++i) {
        const double at = dot(normals[i], result.center);
        result.faces.push_back({normals[i], ends[i][1] - at});
        result.faces.push_back({-normals[i], at - ends[i][0]});
    }
    if (!(size > 0)) {
        result.corners.push_back(Vec3::Zero());
        return result;
    }
    // Try again slightly grown: a polytope without thickness has faces without area.
    for (const double grown : {0.0, 1e-9 * size}) {
        std::vector<FacePlane> planes = result.faces;
        for (FacePlane& plane : planes) plane.offset += grown;
        for (const std::vector<Vec3>& polygon : face_polygons(planes, size + grown))
            result.corners.insert(result.corners.end(), polygon.begin(), polygon.end());
        if (!result.corners.empty()) return result;
    }
    throw InputError("its planes enclose no point");
}

double excess(const NodeVolume& volume, const Vec3& point) {
    return std::visit(Excess{point}, volume);
}

ConvexShape convex_shape(const NodeVolume& volume) {
    return std::visit([](const auto& v) { return shape(v); }, volume);
}

ConvexShape exact_shape(const AnyVolume& volume) {
    return std::visit(
        []<class V>(const V& v) {
            if constexpr (std::is_same_v<V, ConvexShape>)
                return v;
            else if constexpr (std::is_same_v<V, Scb2>)
                return cut_ball_shape(v);
            else
                return shape(v);
        },
        volume);
}

Box box_about(const ConvexShape& shape) {
    Box box;
    for (int i = 0; i < 3; ++i) {
        box.lower[i] = shape.center[i] - support(shape, Vec3(-Vec3::Unit(i)));
        box.upper[i] = shape.center[i] + support(shape, Vec3::Unit(i));
    }
    return box;
}

namespace {

bool has_slab_beside_center(const NodeVolume& volume) {
    const auto* scb = std::get_if<Scb2>(&volume);
    return scb && std::any_of(scb->slabs.begin(), scb->slabs.end(),
                              [](const Slab& slab) { return slab.f > 0 || slab.e < 0; });
}

/// The open box, cut beyond the extents of the other volume so that the cut does not change how the
/// two meet. `to_box`: the pose of the other volume in the box's frame.
Obb cut_about(const OpenBox& box, const ConvexShape& other, const Pose& to_box, double reach) {
    const ConvexShape seen = placed(other, to_box);
    const Box about = box_about(seen);
    const double beyond =
        (about.upper - about.lower).maxCoeff() + std::sqrt(squared_norm(seen.center)) + 1 + reach;
    return cut_box(box, about.lower.array() - beyond, about.upper.array() + beyond);
}

double finite_reach(const OpenBox& box) {
    double reach = 1;
    for (int i = 0; i < 3; ++i)
        for (const double at : {box.lower[i], box.upper[i]})
            if (std::isfinite(at)) reach = std::max(reach, std::abs(at));
    return reach;
}

std::optional<ContactCertificate> open_verdict(const OpenBox& a, const OpenBox& b,
                                               const Pose& b_to_a, double tolerance) {
    const double reach =
        8 * (finite_reach(a) + finite_reach(b) + std::sqrt(squared_norm(b_to_a.translation)));
    const Vec3 far = Vec3::Constant(reach);
    const ContactCertificate found =
        verdict(cut_box(a, -far, far), cut_box(b, -far, far), b_to_a, tolerance);
    // Boxes along the same axes can be compared axis by axis, so the cut decides.
    const bool along =
        (b_to_a.rotation.cwiseAbs().array().round() == b_to_a.rotation.cwiseAbs().array()).all();
    if (found.contact == Contact::disjoint && !along) return std::nullopt;
    return found;
}

bool has_verdict(const NodeVolume& a, const NodeVolume& b) {
    // For such volumes scb2_reach gives only a bound.
    if (has_slab_beside_center(a) || has_slab_beside_center(b)) return false;
    return has_volume(a) && has_volume(b) &&
           std::holds_alternative<Scb2>(a) == std::holds_alternative<Scb2>(b);
}

}  // namespace

ContactCertificate exact_verdict(const ConvexShape& a, const ConvexShape& b, const Pose& b_to_a,
                                 double tolerance, double reach) {
    ConvexShape grown = a;
    grown.rounding += reach;
    return verdict(grown, b, b_to_a, tolerance);
}

ContactCertificate exact_verdict(const NodeVolume& a, const NodeVolume& b, const Pose& b_to_a,
                                 double tolerance, double reach) {
    return proven_verdict(a, b, b_to_a, tolerance, reach).value_or(ContactCertificate{});
}

std::optional<ContactCertificate> proven_verdict(const NodeVolume& a, const NodeVolume& b,
                                                 const Pose& b_to_a, double tolerance,
                                                 double reach) {
    if (!has_verdict(a, b)) return std::nullopt;
    const auto *open_a = std::get_if<OpenBox>(&a), *open_b = std::get_if<OpenBox>(&b);
    if (open_a && open_b && reach > 0) return std::nullopt;
    if (open_a && open_b) return open_verdict(*open_a, *open_b, b_to_a, tolerance);
    if (open_a)
        return proven_verdict(cut_about(*open_a, convex_shape(b), b_to_a, reach), b, b_to_a,
                              tolerance, reach);
    if (open_b)
        return proven_verdict(a, cut_about(*open_b, convex_shape(a), inverse(b_to_a), reach),
                              b_to_a, tolerance, reach);
    if (reach > 0) {
        const auto exact = [](const NodeVolume& volume) {
            const auto* scb = std::get_if<Scb2>(&volume);
            return scb ? cut_ball_shape(*scb) : convex_shape(volume);
        };
        return exact_verdict(exact(a), exact(b), b_to_a, tolerance, reach);
    }
    return std::visit(
        [&]<class V>(const V& va) -> std::optional<ContactCertificate> {
            if constexpr (std::is_same_v<V, Obb> || std::is_same_v<V, Ball> ||
                          std::is_same_v<V, Scb> || std::is_same_v<V, Scb2>) {
                if (const V* vb = std::get_if<V>(&b)) return verdict(va, *vb, b_to_a, tolerance);
            }
            return verdict(convex_shape(a), convex_shape(b), b_to_a, tolerance);
        },
        a);
}

}  // namespace scb
