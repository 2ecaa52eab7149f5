#pragma once

#include "core/analysis/trace_diff.h"
#include "tests/core/hierarchy/built_mesh.h"

namespace scb {

/// A query of distances on two meshes, recorded.
inline void record_distance(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                            const Mesh& mesh_b, const TraceHeader& header, StepRecorder& recorder,
                            QueryTrace& result) {
    if (header.kind == QueryKind::within) {
        result.found = within(a, mesh_a, b, mesh_b, result.b_to_a, header.tolerance,
                              header.distance.descent, recorder);
        return;
    }
    const Distance d = distance(a, mesh_a, b, mesh_b, result.b_to_a, header.distance, recorder);
    result.found.n_v = d.n_v;
    result.found.n_p = d.n_p;
    result.found.n_u = d.n_u;
    result.found.stages = d.stages;
    if (!d.triangles) return;
    result.found.pairs = {*d.triangles};
    result.nearest = d.found;
    result.rounding = 1e-15;
}

/// One query on two meshes, recorded.
inline QueryTrace record_frame(const BuiltMesh& a, const BuiltMesh& b, int frame,
                               const Pose& b_to_a, const TraceHeader& header) {
    const auto kind = static_cast<std::size_t>(header.volume);
    StepRecorder recorder;
    QueryTrace result{frame, b_to_a, {}, {}};
    if (is_of_distance(header.kind)) {
        record_distance(a.hierarchies[kind], a.mesh, b.hierarchies[kind], b.mesh, header, recorder,
                        result);
        result.steps = std::move(recorder.steps);
        return result;
    }
    result.found = header.kind == QueryKind::self
                       ? collide_self(a.hierarchies[kind], a.mesh, joined_vertices(a.mesh),
                                      header.options, recorder)
                       : collide(a.hierarchies[kind], a.mesh, b.hierarchies[kind], b.mesh, b_to_a,
                                 header.options, recorder);
    result.steps = std::move(recorder.steps);
    return result;
}

/// B slides along x, by `step` a frame, through A.
inline Trace record_trace(const BuiltMesh& a, const BuiltMesh& b, TraceHeader header,
                          const std::vector<int>& frames, double step = 0.05) {
    header.scb_version = "1.2.3";
    header.source = {"a.ply", "b.ply"};
    header.scene = "slide";
    header.bodies = {TraceBody{"left", fingerprint(a.mesh)},
                     TraceBody{"right", fingerprint(b.mesh)}};
    if (header.kind == QueryKind::self) header.bodies[1] = header.bodies[0];
    Trace trace{header, {}};
    for (const int frame : frames) {
        Pose pose;
        pose.translation = Vec3(0.4 - step * frame, 0.01, 0.02);
        trace.frames.push_back(record_frame(a, b, frame, pose, header));
    }
    return trace;
}

inline TraceHeader asking(VolumeKind volume, OverlapTest test) {
    TraceHeader header;
    header.volume = volume;
    header.options.overlap.test = test;
    return header;
}

inline TraceHeader asking_self(VolumeKind volume) {
    TraceHeader header = asking(volume, OverlapTest::symmetric);
    header.kind = QueryKind::self;
    return header;
}

inline TraceHeader asking_distance(VolumeKind volume, const DistanceOptions& limits = {}) {
    TraceHeader header = asking(volume, OverlapTest::symmetric);
    header.kind = QueryKind::distance;
    header.distance = limits;
    header.options.descent = limits.descent;
    return header;
}
inline TraceHeader asking_within(VolumeKind volume, double tolerance) {
    TraceHeader header = asking_distance(volume);
    header.kind = QueryKind::within;
    header.tolerance = tolerance;
    return header;
}

/// Queries that tests take parts of: one down to the triangles, one down to a level.
inline std::vector<TraceHeader> queries_to_divide() {
    TraceHeader to_level = asking(VolumeKind::obb, OverlapTest::symmetric);
    to_level.options.stop_level = 4;
    return {asking(VolumeKind::scb, OverlapTest::symmetric), to_level};
}
inline Pose pose_to_divide() { return {Mat3::Identity(), Vec3(0.3, 0.11, 0.02)}; }

}  // namespace scb
