#pragma once

#include <cstddef>
#include <vector>

#include "core/analysis/attribution.h"
#include "core/analysis/inspection.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/hierarchy/built_mesh.h"

namespace scb::scenes {

/// One query of two meshes at one pose, and why its pairs passed.
struct AttributedQuery {
    const BuiltMesh &a, &b;
    TraceHeader header;
    QueryTrace frame;
    std::vector<IndexPair> contacts;
    Attribution result;

    AttributedQuery(const BuiltMesh& mesh_a, const BuiltMesh& mesh_b, const Pose& pose,
                    VolumeKind kind, OverlapTest test, QueryKind query = QueryKind::collide)
        : a(mesh_a), b(mesh_b), header(asking(kind, test)) {
        header.kind = query;
        frame = record_frame(a, b, 0, pose, header);
        const auto i = static_cast<std::size_t>(kind);
        contacts = all_contacts(a.hierarchies[i], a.mesh, b.hierarchies[i], b.mesh, header, frame);
        result = attribute(a.hierarchies[i], b.hierarchies[i], header, frame, contacts);
    }
};

}  // namespace scb::scenes
