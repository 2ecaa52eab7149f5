#include "core/explain/box_room.h"

#include <algorithm>

namespace scb {

BoxRoom room_about(const Obb& box, const Vec3& from_center) {
    BoxRoom room;
    room.box.axes = box.axes;
    for (int i = 0; i < 3; ++i) {
        const double left = box.half[i] - std::abs(dot(Vec3(box.axes.col(i)), from_center));
        room.outside = std::max(room.outside, -left);
        room.box.half[i] = std::max(0.0, left);
    }
    return room;
}

BoxRoom room_about(const Scb2& scb, const Vec3& from_center) {
    BoxRoom room;
    const double to_sphere = scb.r - std::sqrt(squared_norm(from_center));
    // Moves towards the center into the ball, then to the planes. No step undoes the others.
    room.outside = std::max(0.0, -to_sphere);
    for (int i = 0; i < 2; ++i) {
        const Slab& slab = scb.slabs[static_cast<std::size_t>(i)];
        const double height = dot(slab.n, from_center),
                     left = std::min(slab.e - height, height - slab.f);
        room.outside += std::max(0.0, -left);
        room.box.axes.col(i) = slab.n;
        room.box.half[i] = std::max(0.0, left);
    }
    room.box.axes.col(2) = long_axis(scb);
    // After the move to contain the point, less of the ball may be free.
    const double ball = std::max(0.0, to_sphere - room.outside);
    room.ball = std::min({ball, room.box.half[0], room.box.half[1]});
    room.box.half[2] = ball;
    room.box.half = room.box.half.cwiseMin(ball / std::sqrt(3.0));
    return room;
}

double depth_of(const BoxRoom& a, const BoxRoom& b) {
    double least = HUGE_VAL;
    visit_box_directions(a.box, b.box, [&](const Vec3& d) {
        least = std::min(least, support(a.box, d) + support(b.box, d));
    });
    return std::max(least, a.ball + b.ball) - a.outside - b.outside;
}

}  // namespace scb
