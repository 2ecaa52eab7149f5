#include "core/volumes/any_volume.h"

#include "core/volumes/measured_shape.h"

namespace scb {

Scb placed(const Scb& volume, const Pose& pose) {
    return {transform_point(pose, volume.c), volume.r, transform_direction(pose, volume.n),
            volume.e, volume.f};
}

Scb2 placed(const Scb2& volume, const Pose& pose) {
    Scb2 result = volume;
    result.c = transform_point(pose, volume.c);
    for (Slab& slab : result.slabs) slab.n = transform_direction(pose, slab.n);
    return result;
}

Ball placed(const Ball& volume, const Pose& pose) {
    return {transform_point(pose, volume.center), volume.radius};
}

Obb placed(const Obb& volume, const Pose& pose) {
    Obb result;
    result.center = transform_point(pose, volume.center);
    for (int i = 0; i < 3; ++i) result.axes.col(i) = transform_direction(pose, volume.axes.col(i));
    result.half = volume.half;
    return result;
}

Vec3 center(const AnyVolume& volume) {
    return std::visit([](const auto& shape) { return shape_center(shape); }, volume);
}

VolumeSize size_of(const ConvexShape& shape) {
    const VolumeLengths lengths = lengths_of(shape);
    const SurfaceMeasures measures =
        polytope_measures(planes_about(shape, touching_directions()), lengths.diameter);
    return {lengths, measures.area, measures.volume};
}

AnyVolume placed(const AnyVolume& volume, const Pose& pose) {
    return std::visit([&](const auto& v) { return AnyVolume(placed(v, pose)); }, volume);
}

double reach(const AnyVolume& volume, const Vec3& direction) {
    const double offset = std::visit([&](const auto& v) { return support(v, direction); }, volume);
    return dot(center(volume), direction) + offset;
}

bool identical(const Scb& a, const Scb& b) {
    return a.c == b.c && a.r == b.r && a.n == b.n && a.e == b.e && a.f == b.f;
}

bool identical(const Scb2& a, const Scb2& b) {
    const auto same = [](const Slab& p, const Slab& q) {
        return p.n == q.n && p.e == q.e && p.f == q.f;
    };
    return a.c == b.c && a.r == b.r && same(a.slabs[0], b.slabs[0]) && same(a.slabs[1], b.slabs[1]);
}

bool identical(const Ball& a, const Ball& b) {
    return a.center == b.center && a.radius == b.radius;
}

bool identical(const Obb& a, const Obb& b) {
    return a.center == b.center && a.axes == b.axes && a.half == b.half;
}

bool identical(const AnyVolume& a, const AnyVolume& b) {
    return std::visit(
        [&]<class V>(const V& of_a) {
            const V* of_b = std::get_if<V>(&b);
            return of_b != nullptr && identical(of_a, *of_b);
        },
        a);
}

}  // namespace scb
