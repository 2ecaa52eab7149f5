#include <algorithm>
#include <cmath>

#include "core/explain/box_room.h"
#include "core/explain/exact_overlap.h"

namespace scb {
namespace {

/// Adds up the ends of the parts of a box's edges inside another box: corners of their
/// intersection.
struct CornerSum {
    Vec3 sum = Vec3::Zero();
    int count = 0;

    /// Adds the edges of `of`, cut by `by`. `center` is the center of `of`, from the center of
    /// `by`; the corners are added with `shift`. `by` is grown by `slop`, so that rounding loses
    /// none.
    void add_edges(const Obb& of, const Obb& by, const Vec3& center, const Vec3& shift,
                   double slop) {
        for (int axis = 0; axis < 3; ++axis)
            for (const double u : {-1.0, 1.0})
                for (const double v : {-1.0, 1.0}) {
                    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
                    const Vec3 middle = center + u * of.half[second] * Vec3(of.axes.col(second)) +
                                        v * of.half[third] * Vec3(of.axes.col(third));
                    add_part(middle, of.axes.col(axis), of.half[axis], by, shift, slop);
                }
    }

  private:
    void add_part(const Vec3& middle, const Vec3& along, double half, const Obb& by,
                  const Vec3& shift, double slop) {
        double from = -half, to = half;
        for (int i = 0; i < 3; ++i) {
            const double at = dot(Vec3(by.axes.col(i)), middle),
                         slope = dot(Vec3(by.axes.col(i)), along), reach = by.half[i] + slop;
            if (std::abs(slope) < 1e-15) {
                if (std::abs(at) > reach) return;
                continue;
            }
            const double first = (-reach - at) / slope, second = (reach - at) / slope;
            from = std::max(from, std::min(first, second));
            to = std::min(to, std::max(first, second));
        }
        if (from > to) return;
        sum += (middle + from * along + shift) + (middle + to * along + shift);
        count += 2;
    }
};

}  // namespace

ContactCertificate exact_overlap(const Obb& a, const Obb& b, double tolerance) {
    const double larger = std::max(diameter(a), diameter(b)) / 2, least = tolerance * larger;
    const Vec3 to_b = b.center - a.center;
    ContactCertificate certificate;
    double gap = -HUGE_VAL;
    visit_box_directions(a, b, [&](const Vec3& d) {
        const double distance = dot(d, to_b),
                     g = std::abs(distance) - support(a, d) - support(b, d);
        if (g > gap) {
            gap = g;
            certificate.direction = distance < 0 ? Vec3(-d) : d;
        }
    });
    if (gap > least) {
        certificate.contact = Contact::disjoint;
        certificate.margin = gap;
        return certificate;
    }
    certificate.direction = Vec3::Zero();
    CornerSum corners;
    const double slop = 1e-14 * larger;
    corners.add_edges(a, b, -to_b, to_b, slop);
    corners.add_edges(b, a, to_b, Vec3::Zero(), slop);
    if (corners.count == 0) return certificate;
    certificate.point = corners.sum / corners.count;
    const double depth =
        depth_of(room_about(a, certificate.point), room_about(b, certificate.point - to_b));
    if (depth > least) {
        certificate.contact = Contact::overlapping;
        certificate.margin = depth;
    } else {
        certificate.point = Vec3::Zero();
    }
    return certificate;
}

}  // namespace scb
