#include "core/geometry/surface_moments.h"

#include <cmath>

namespace scb {
namespace {

void add_outer_product(Mat3& m, double weight, const Vec3& v) {
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) m(i, j) += weight * v[i] * v[j];
}

}  // namespace

SurfaceMoments triangle_moments(const Vec3& a, const Vec3& b, const Vec3& c) {
    SurfaceMoments m;
    m.area = std::sqrt(squared_norm(cross(b - a, c - a))) / 2;
    m.centroid = (a + b + c) / 3;
    // The integral over a triangle of a quadratic form about its centroid: area / 12 times the sum
    // over the corners.
    for (const Vec3& corner : {a, b, c})
        add_outer_product(m.scatter, m.area / 12, corner - m.centroid);
    return m;
}

SurfaceMoments merge(const SurfaceMoments& a, const SurfaceMoments& b) {
    SurfaceMoments m;
    m.area = a.area + b.area;
    if (m.area <= 0) {
        m.centroid = (a.centroid + b.centroid) / 2;
        return m;
    }
    const double share = b.area / m.area;
    const Vec3 between = b.centroid - a.centroid;
    m.centroid = a.centroid + share * between;
    m.scatter = a.scatter + b.scatter;
    add_outer_product(m.scatter, a.area * share, between);
    return m;
}

}  // namespace scb
