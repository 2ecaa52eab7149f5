#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/peers/peer.h"
#define SCB_RECORD_ON
#include <scb_record.h>

namespace scb {

/// Makes a query of an engine of somebody else's, and records its tests and pairs: body 0 at `a`,
/// body 1 at `b`.
using RecordedQuery = std::function<void(const PeerPose& a, const PeerPose& b)>;

/// Has the engine build its trees of two meshes, and records them. The recorder lives longer than
/// what is returned.
using MakeEngine = RecordedQuery(scb_recorder& recorder, const PeerMesh& a, const PeerMesh& b);
MakeEngine record_fcl, record_bullet, record_embree, record_cgal;

/// A mesh with a body of the same number, and the start of its tree, whose nodes follow.
template <class Real = double>
void record_body(scb_recorder& recorder, std::uint32_t number, const PeerMesh& mesh) {
    std::vector<Real> vertices;
    for (const auto& vertex : mesh.vertices)
        for (const double x : vertex) vertices.push_back(static_cast<Real>(x));
    const char* name = number == 0 ? "A" : "B";
    scb_record_mesh(&recorder, number, name, vertices.data(), sizeof(Real), 0,
                    static_cast<std::uint32_t>(mesh.vertices.size()), mesh.triangles.data(), 4,
                    static_cast<std::uint32_t>(mesh.triangles.size()));
    scb_record_tree(&recorder, number, name, number, nullptr, 0);
    scb_record_body(&recorder, number, name, number);
}

}  // namespace scb
