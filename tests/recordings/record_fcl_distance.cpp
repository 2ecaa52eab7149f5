// FCL: the bounds and the measured triangles of its distance queries, and its answer.
#include <fcl/math/bv/RSS.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

#include <fcl/narrowphase/detail/traversal/distance/mesh_distance_traversal_node.h>

#include "tests/recordings/fcl_nodes.h"

namespace scb {
namespace {

using Node = fcl::detail::MeshDistanceTraversalNodeRSSd;
using Model = fcl::BVHModel<fcl::RSSd>;
using Index = std::uint32_t;

/// FCL calls these two for each test.
struct RecordingNode : Node {
    using Node::BVTesting;
    using Node::leafTesting;
    scb_recorder* recorder = nullptr;

    double BVTesting(int a, int b) const override {
        const double bound = Node::BVTesting(a, b);
        scb_record_bound(recorder, static_cast<Index>(a), static_cast<Index>(b), bound, 0);
        return bound;
    }
    void leafTesting(int a, int b) const override {
        const double before = result->min_distance;
        Node::leafTesting(a, b);
        // FCL keeps only distances that are smaller than the smallest before.
        if (result->min_distance < before) scb_record_length(recorder, result->min_distance);
        scb_record_items(recorder, triangle_of(*model1, a), triangle_of(*model2, b), 0);
    }
};

std::vector<double> values_of(const fcl::RSSd& rss) {
    std::vector<double> values;
    for (int k = 0; k < 3; ++k) values.push_back(rss.To[k]);
    for (int side = 0; side < 2; ++side)
        for (int k = 0; k < 3; ++k) values.push_back(rss.axis(k, side) * rss.l[side]);
    values.push_back(rss.r);
    return values;
}

}  // namespace

RecordedQuery record_fcl_distance(scb_recorder& recorder, const PeerMesh& a, const PeerMesh& b) {
    const auto models = std::make_shared<std::array<Model, 2>>();
    for (const Index i : {0u, 1u})
        record_fcl_body(recorder, i, i == 0 ? a : b, (*models)[i], SCB_RECORD_RSS, values_of);
    return [&recorder, models](const PeerPose& at_a, const PeerPose& at_b) {
        scb_record_nearest(&recorder, HUGE_VAL, 0);
        const fcl::DistanceRequestd request(true);
        fcl::DistanceResultd result;
        RecordingNode node;
        node.recorder = &recorder;
        fcl::detail::initialize(node, (*models)[0], transform(at_a), (*models)[1], transform(at_b),
                                request, result);
        fcl::detail::distance<double>(&node);
        double points[6];
        for (int k = 0; k < 6; ++k) points[k] = result.nearest_points[k / 3][k % 3];
        scb_record_distance(&recorder, result.min_distance, static_cast<Index>(result.b1),
                            static_cast<Index>(result.b2), points);
    };
}

}  // namespace scb
