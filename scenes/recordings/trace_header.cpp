#include <cmath>

#include "scb/mesh.h"
#include "scenes/recordings/byte_stream.h"
#include "scenes/recordings/trace_block.h"
#include "scenes/scene/scene.h"

namespace scb::scenes {
namespace {

// How the hierarchies were built and which kind of query it is, in a byte. A query of distances has
// its kind and its limits behind the others.
constexpr std::uint8_t ritter_bit = 1, cost_bit = 2, self_bit = 4, distance_bit = 8;

void write_limits(ByteWriter& out, const TraceHeader& header) {
    out.text(query_kind_name(header.kind));
    if (header.kind == QueryKind::within) return out.real(header.tolerance);
    const DistanceOptions& limits = header.distance;
    out.text(distance_order_name(limits.order));
    out.varint(limits.heap);
    out.real(limits.enough);
    out.real(limits.relative_error);
    out.real(limits.limit);
    out.byte(limits.seed ? 1 : 0);
    if (!limits.seed) return;
    out.varint(limits.seed->a);
    out.varint(limits.seed->b);
}

bool is_length(double value) { return std::isfinite(value) && value >= 0; }

/// Returns whether a query can have what was read.
bool read_limits(ByteReader& in, TraceHeader& header) {
    const std::string kind = in.text();
    if (kind == query_kind_name(QueryKind::within)) {
        header.kind = QueryKind::within;
        header.tolerance = in.real();
        return is_length(header.tolerance);
    }
    header.kind = QueryKind::distance;
    DistanceOptions& limits = header.distance;
    const auto order = distance_order_of(in.text());
    limits.heap = static_cast<std::size_t>(in.varint());
    limits.enough = in.real();
    limits.relative_error = in.real();
    limits.limit = in.real();
    const std::uint8_t seeds = in.byte();
    if (seeds == 1) {
        const std::uint64_t a = in.varint(), b = in.varint();
        if (a >= header.bodies[0].mesh.triangles || b >= header.bodies[1].mesh.triangles)
            return false;
        limits.seed = IndexPair{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)};
    }
    limits.order = order.value_or(DistanceOrder{});
    return kind == query_kind_name(QueryKind::distance) && order && seeds <= 1 &&
           std::isfinite(limits.enough) && is_length(limits.relative_error) && limits.limit >= 0;
}

}  // namespace

std::vector<std::uint8_t> header_bytes(const TraceHeader& header) {
    ByteWriter out;
    out.text(header.scb_version);
    out.varint(header.source.size());
    for (const std::string& word : header.source) out.text(word);
    out.text(header.scene);
    for (const TraceBody& body : header.bodies) {
        out.text(body.name);
        out.varint(body.mesh.triangles);
        out.varint(body.mesh.vertices);
        out.fixed64(body.mesh.hash);
    }
    // By name, so that the order of the lists may change.
    out.text(volume_kind_name(header.volume));
    out.byte(static_cast<std::uint8_t>((header.growth == BallGrowth::ritter ? ritter_bit : 0) |
                                       (header.split == SplitMethod::cost ? cost_bit : 0) |
                                       (header.kind == QueryKind::self ? self_bit : 0) |
                                       (is_of_distance(header.kind) ? distance_bit : 0)));
    out.real(header.margin);
    out.text(overlap_test_name(header.options.overlap.test));
    out.real(header.options.overlap.threshold);
    out.text(descent_rule_name(header.options.descent));
    out.varint(header.options.max_pairs);
    out.signed_varint(header.options.stop_level);
    if (is_of_distance(header.kind)) write_limits(out, header);
    return std::move(out.bytes);
}

std::optional<TraceHeader> header_of(std::span<const std::uint8_t> bytes) {
    ByteReader in{bytes};
    TraceHeader header;
    header.scb_version = in.text();
    for (std::uint64_t words = in.varint(); words > 0 && in.ok; --words)
        header.source.push_back(in.text());
    header.scene = in.text();
    // The name becomes a part of file names.
    bool legal = header.scene == file_name_of(header.scene);
    for (TraceBody& body : header.bodies) {
        body.name = in.text();
        const std::uint64_t triangles = in.varint(), vertices = in.varint();
        legal &= triangles >= 1 && triangles <= max_triangles && vertices <= max_vertices;
        body.mesh = {static_cast<std::uint32_t>(triangles), static_cast<std::uint32_t>(vertices),
                     in.fixed64()};
    }
    const auto volume = volume_kind_of(in.text());
    const std::uint8_t build = in.byte();
    header.growth = (build & ritter_bit) != 0 ? BallGrowth::ritter : BallGrowth::radius;
    header.split = (build & cost_bit) != 0 ? SplitMethod::cost : SplitMethod::section_3;
    header.kind = (build & self_bit) != 0 ? QueryKind::self : QueryKind::collide;
    header.margin = in.real();
    const auto test = overlap_test_of(in.text());
    header.options.overlap.threshold = in.real();
    const auto descent = descent_rule_of(in.text());
    header.options.max_pairs = static_cast<std::size_t>(in.varint());
    const std::int64_t level = in.signed_varint();
    const bool is_distance = (build & distance_bit) != 0;
    if (is_distance) legal &= (build & self_bit) == 0 && level == -1 && read_limits(in, header);
    legal &= build <= (ritter_bit | cost_bit | self_bit | distance_bit) && level >= -1 &&
             level <= 0xffff && header.options.max_pairs >= 1 && header.margin >= 0 &&
             header.margin <= 1 && header.options.overlap.threshold >= 0 &&
             header.options.overlap.threshold <= 1;
    legal &= header.kind != QueryKind::self || header.bodies[0].mesh == header.bodies[1].mesh;
    if (!in.ok || !in.bytes.empty() || !legal || !volume || !test || !descent) return std::nullopt;
    header.volume = *volume;
    header.options.overlap.test = *test;
    header.options.descent = *descent;
    if (is_distance) header.distance.descent = *descent;
    header.options.stop_level = static_cast<int>(level);
    return header;
}

}  // namespace scb::scenes
