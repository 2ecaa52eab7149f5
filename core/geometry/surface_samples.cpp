#include "core/geometry/surface_samples.h"

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

}  // namespace scb
