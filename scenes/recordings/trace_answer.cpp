#include "scenes/recordings/trace_answer.h"

#include <algorithm>
#include <cmath>

namespace scb::scenes {

void write_answer(ByteWriter& out, const QueryTrace& frame) {
    out.byte(frame.nearest ? 1 : 0);
    if (!frame.nearest) return;
    const IndexPair triangles = frame.found.pairs.front();
    out.varint(triangles.a);
    out.varint(triangles.b);
    out.real(frame.nearest->distance);
    for (const Vec3& point : {frame.nearest->point_a, frame.nearest->point_b})
        for (int i = 0; i < 3; ++i) out.real(point[i]);
    out.real(frame.rounding);
}

std::string read_answer(ByteReader& in, const TraceHeader& header, QueryTrace& frame) {
    const auto& items = frame.steps.items;
    const auto& seed = header.distance.seed;
    frame.found.n_p += seed ? 1 : 0;
    const bool has_hits =
        std::any_of(items.begin(), items.end(), [](const ItemStep& item) { return item.hit; });
    const std::uint8_t answers = in.byte();
    if (!in.ok || answers > 1 || (answers == 0 && has_hits)) return "its answer cannot be read";
    if (answers == 0) return {};
    const std::uint64_t a = in.varint(), b = in.varint();
    TriangleDistance nearest;
    nearest.distance = in.real();
    for (Vec3* point : {&nearest.point_a, &nearest.point_b})
        for (int i = 0; i < 3; ++i) (*point)[i] = in.real();
    frame.rounding = in.real();
    const bool is_finite = std::isfinite(nearest.distance) && nearest.point_a.allFinite() &&
                           nearest.point_b.allFinite() && std::isfinite(frame.rounding);
    if (!in.ok || !is_finite || nearest.distance < 0 || nearest.distance > header.distance.limit ||
        frame.rounding < 0)
        return "its answer cannot be read";
    const auto is_answer = [a, b](const IndexPair& pair) { return pair.a == a && pair.b == b; };
    if (!(seed && is_answer(*seed)) &&
        std::none_of(items.begin(), items.end(),
                     [&](const ItemStep& item) { return item.hit && is_answer(item.items); }))
        return "its answer is none of the triangles that it measured";
    frame.nearest = nearest;
    frame.found.pairs = {{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)}};
    return {};
}

}  // namespace scb::scenes
