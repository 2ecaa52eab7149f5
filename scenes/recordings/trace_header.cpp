#include "scb/mesh.h"
#include "scenes/recordings/byte_stream.h"
#include "scenes/recordings/trace_block.h"
#include "scenes/scene/scene.h"

namespace scb::scenes {
namespace {

// How the hierarchies were built and which kind of query it is, in a byte.
constexpr std::uint8_t ritter_bit = 1, cost_bit = 2, self_bit = 4;

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
                                       (header.kind == QueryKind::self ? self_bit : 0)));
    out.real(header.margin);
    out.text(overlap_test_name(header.options.overlap.test));
    out.real(header.options.overlap.threshold);
    out.text(descent_rule_name(header.options.descent));
    out.varint(header.options.max_pairs);
    out.signed_varint(header.options.stop_level);
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
    legal &= build <= (ritter_bit | cost_bit | self_bit) && level >= -1 && level <= 0xffff &&
             header.options.max_pairs >= 1 && header.margin >= 0 && header.margin <= 1 &&
             header.options.overlap.threshold >= 0 && header.options.overlap.threshold <= 1;
    legal &= header.kind != QueryKind::self || header.bodies[0].mesh == header.bodies[1].mesh;
    if (!in.ok || !in.bytes.empty() || !legal || !volume || !test || !descent) return std::nullopt;
    header.volume = *volume;
    header.options.overlap.test = *test;
    header.options.descent = *descent;
    header.options.stop_level = static_cast<int>(level);
    return header;
}

}  // namespace scb::scenes
