#include "render/view/any_volume.h"

namespace scb::render {

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

}  // namespace scb::render
