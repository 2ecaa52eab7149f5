#pragma once

#include <gtest/gtest.h>

#include "scenes/recordings/recording_block.h"
#include "scenes/recordings/trace_block.h"
#include "scenes/shapes/procedural.h"
#include "tests/core/analysis/traces.h"
#include "tests/scenes/recordings/trace_1_0.h"
#include "tests/scenes/support.h"

namespace scb::scenes {

using Bytes = std::vector<std::uint8_t>;

inline const BuiltMesh& soup_a() {
    static const BuiltMesh mesh(soup_mesh({120, 0.6, 0.15, 1}));
    return mesh;
}
inline const BuiltMesh& soup_b() {
    static const BuiltMesh mesh(soup_mesh({90, 0.6, 0.15, 2}));
    return mesh;
}

inline Trace small_trace(const TraceHeader& header = asking(VolumeKind::scb,
                                                            OverlapTest::symmetric)) {
    return record_trace(soup_a(), soup_b(), header, {4, 7, 12});
}

/// Queries of distances of all orders and limits, near and far, and bodies that touch.
inline std::vector<Trace> distance_traces(VolumeKind kind) {
    std::vector<TraceHeader> headers;
    for (const DistanceOrder order :
         {DistanceOrder::nearest, DistanceOrder::depth_first, DistanceOrder::hybrid})
        headers.push_back(asking_distance(kind, {.order = order}));
    headers.push_back(asking_distance(kind, {.heap = 3}));
    headers.push_back(asking_distance(kind, {.descent = DescentRule::alternating}));
    headers.push_back(asking_distance(kind, {.enough = 0.5, .limit = 0.5}));
    headers.push_back(asking_distance(kind, {.relative_error = 0.25}));
    headers.push_back(asking_distance(kind, {.seed = IndexPair{7, 11}}));
    headers.push_back(asking_within(kind, 0));
    headers.push_back(asking_within(kind, 0.3));
    std::vector<Trace> traces;
    for (const TraceHeader& header : headers)
        traces.push_back(record_trace(soup_a(), soup_b(), header, {3, 12, 40}, 0.1));
    // The first triangles that a query measures intersect.
    const QueryTrace contact =
        record_trace(soup_a(), soup_b(), asking_within(kind, 0), {3}, 0.1).frames[0];
    const IndexPair touching = contact.found.pairs.at(0);
    traces.push_back(
        record_trace(soup_a(), soup_b(), asking_distance(kind, {.seed = touching}), {3}, 0.1));
    return traces;
}

inline void expect_same_answer(const QueryTrace& f, const QueryTrace& g) {
    ASSERT_EQ(f.nearest.has_value(), g.nearest.has_value());
    EXPECT_EQ(f.rounding, g.rounding);
    if (!f.nearest) return;
    EXPECT_EQ(f.nearest->distance, g.nearest->distance);
    EXPECT_EQ(f.nearest->point_a, g.nearest->point_a);
    EXPECT_EQ(f.nearest->point_b, g.nearest->point_b);
}

inline void expect_same(const Trace& a, const Trace& b) {
    EXPECT_EQ(fields_of(a.header), fields_of(b.header));
    EXPECT_EQ(a.header.scb_version, b.header.scb_version);
    EXPECT_EQ(a.header.source, b.header.source);
    ASSERT_EQ(a.frames.size(), b.frames.size());
    for (std::size_t i = 0; i < a.frames.size(); ++i) {
        const QueryTrace &f = a.frames[i], &g = b.frames[i];
        EXPECT_EQ(f.frame, g.frame);
        EXPECT_EQ(f.b_to_a.rotation, g.b_to_a.rotation);
        EXPECT_EQ(f.b_to_a.translation, g.b_to_a.translation);
        EXPECT_EQ(f.steps, g.steps);
        EXPECT_EQ(f.found.pairs, g.found.pairs);
        EXPECT_EQ(f.found.n_v, g.found.n_v);
        EXPECT_EQ(f.found.n_p, g.found.n_p);
        EXPECT_EQ(f.found.n_u, g.found.n_u);
        EXPECT_EQ(f.found.stages, g.found.stages);
        EXPECT_EQ(f.found.depth, g.found.depth);
        EXPECT_EQ(f.found.complete, g.found.complete);
        expect_same_answer(f, g);
    }
}

inline std::string refusal_of(const Bytes& bytes) {
    return refusal([&] { decode_trace(bytes, "file.scbrec"); });
}

/// A trace of these frames, as plain bytes.
inline Bytes file_of(const TraceHeader& header, const std::vector<Bytes>& frames) {
    ByteWriter out;
    begin_recording(out);
    add_block(out, head_block, header_bytes(header));
    for (const Bytes& frame : frames) add_packed_block(out, step_block, frame);
    add_block(out, data_block, Bytes{203, 0, 0, 0, 0});
    return out.bytes;
}

/// The bytes of a file of scb 1.0 with the checksum that fits them.
inline Bytes resealed_1_0(Bytes bytes) {
    bytes.resize(bytes.size() - 4);
    ByteWriter out{bytes};
    out.fixed32(checksum(bytes));
    return out.bytes;
}

}  // namespace scb::scenes
