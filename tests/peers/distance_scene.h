#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scenes/scene/scene.h"
#include "tests/peers/peer_timing.h"
#include "tests/peers/scb_distance.h"

namespace scb {

/// Two bodies, and where their distance is compared.
struct DistanceScene {
    /// Poses whose times are averaged.
    struct Row {
        std::string gap;  ///< the distance in all poses; "-" if the poses are frames of a scene
        std::vector<PeerPoses> poses;
    };
    std::unique_ptr<DistanceBodies> bodies;
    std::vector<Row> rows;
};

/// The mesh, scaled and moved so that its box is centered and its longest side is 1.
Mesh normalized(const Mesh& mesh);

/// Two copies of a mesh whose longest side is scaled to 1: for each gap, in these units, random
/// poses of B with this distance, to 1e-6 of the gap. The same on every machine.
DistanceScene scene_of_gaps(const Mesh& mesh, const std::vector<double>& gaps, std::size_t poses);

/// The first two bodies of a scene at so many frames, evenly spread. One row.
DistanceScene scene_of_frames(const scenes::Scene& scene, std::size_t frames);

}  // namespace scb
