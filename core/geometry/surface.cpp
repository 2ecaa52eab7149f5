#include "core/geometry/surface.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

namespace scb {
namespace {

double triangle_area(const Mesh& mesh, const Triangle& t) {
    const Vec3& a = mesh.vertices[t[0]];
    return std::sqrt(squared_norm(cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a))) / 2;
}

}  // namespace

double surface_area(const Mesh& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles) sum += triangle_area(mesh, t);
    return sum;
}

std::vector<SurfaceSample> surface_samples(const Mesh& mesh, std::size_t count) {
    std::vector<SurfaceSample> samples;
    const double area = surface_area(mesh);
    if (!(area > 0)) return samples;
    Random random(0);
    const double part = area / static_cast<double>(count);
    double reached = 0;  // the area of the triangles so far
    std::size_t next = 0;
    double at = random.uniform() * part;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        reached += triangle_area(mesh, t);
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        while (next < count && at < reached) {
            // Uniform in the triangle (Turk, "Generating Random Points in Triangles", 1990).
            const double s = std::sqrt(random.uniform()), u = s * random.uniform();
            samples.push_back({a * (1 - s) + b * (s - u) + c * u, i});
            ++next;
            at = (static_cast<double>(next) + random.uniform()) * part;
        }
    }
    return samples;
}

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
